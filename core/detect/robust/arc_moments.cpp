// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_moments.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace scanbed {

void ArcMoments::begin(const Echoes& echoes, const std::vector<int>& order) {
  echoes_ = &echoes;
  order_ = &order;
  sums_.resize(order.size());
  is_summed_.assign(order.size(), 0);
}

void ArcMoments::sum_up(Stretch surface) {
  if (is_summed_[surface.first] != 0) return;
  is_summed_[surface.first] = 1;
  Sums sum;
  for (int i = surface.first; i <= surface.last; ++i) {
    const int k = (*order_)[i];
    const double x = echoes_->x_m[k];
    const double y = echoes_->y_m[k];
    const double w = 1.0 / (echoes_->sigma_m[k] * echoes_->sigma_m[k]);
    const double z = x * x + y * y;
    sum.w += w;
    sum.x += w * x;
    sum.y += w * y;
    sum.xx += w * x * x;
    sum.xy += w * x * y;
    sum.yy += w * y * y;
    sum.xz += w * x * z;
    sum.yz += w * y * z;
    sum.zz += w * z * z;
    sums_[i] = sum;
  }
}

double ArcMoments::chi2(Stretch surface, Stretch places) {
  sum_up(surface);
  if (places.first == surface.first) return chi2_of(sums_[places.last]);
  const Sums& a = sums_[places.first - 1];
  const Sums& b = sums_[places.last];
  return chi2_of({b.w - a.w, b.x - a.x, b.y - a.y, b.xx - a.xx, b.xy - a.xy, b.yy - a.yy, b.xz - a.xz,
                  b.yz - a.yz, b.zz - a.zz});
}

double ArcMoments::chi2_of_both(Stretch a, Stretch b) {
  sum_up(a);
  sum_up(b);
  const Sums& s = sums_[a.last];
  const Sums& t = sums_[b.last];
  return chi2_of({s.w + t.w, s.x + t.x, s.y + t.y, s.xx + t.xx, s.xy + t.xy, s.yy + t.yy, s.xz + t.xz,
                  s.yz + t.yz, s.zz + t.zz});
}

double ArcMoments::chi2_of(const Sums& s) {
  constexpr double kNoArc = std::numeric_limits<double>::infinity();
  const double mx = s.x / s.w;
  const double my = s.y / s.w;
  const double z = s.xx + s.yy;
  const double xx = s.xx - mx * s.x;
  const double xy = s.xy - mx * s.y;
  const double yy = s.yy - my * s.y;
  const double xz = s.xz - mx * z;
  const double yz = s.yz - my * z;
  const double zz = s.zz - z * z / s.w;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return kNoArc;
  // z + d x + e y + f = 0 with least squared sum.
  const double d = -(yy * xz - xy * yz) / determinant;
  const double e = -(xx * yz - xy * xz) / determinant;
  const double rest = zz + d * xz + e * yz;
  const Eigen::Vector2d center(-0.5 * d, -0.5 * e);
  const Eigen::Vector2d mean(mx, my);
  if ((mean - center).dot(center) >= 0.0) return kNoArc;
  const double radius2 = (center - mean).squaredNorm() + (z - mx * s.x - my * s.y) / s.w;
  return std::max(0.0, rest) / (4.0 * radius2);
}

}  // namespace scanbed
