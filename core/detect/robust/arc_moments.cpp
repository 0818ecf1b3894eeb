// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_moments.hpp"

#include <limits>

namespace scanbed {

void ArcMoments::build(const Echoes& echoes, const std::vector<int>& order, Stretch surface) {
  first_ = surface.first;
  origin_m_ = echoes.point_m(order[surface.first]);
  sums_.resize(static_cast<std::size_t>(surface.size()) + 1);
  Sums sum;
  sums_[0] = sum;
  for (int i = 0; i < surface.size(); ++i) {
    const int k = order[surface.first + i];
    const Eigen::Vector2d p = echoes.point_m(k) - origin_m_;
    const double w = 1.0 / (echoes.sigma_m[k] * echoes.sigma_m[k]);
    const double z = p.squaredNorm();
    sum.w += w;
    sum.x += w * p.x();
    sum.y += w * p.y();
    sum.xx += w * p.x() * p.x();
    sum.xy += w * p.x() * p.y();
    sum.yy += w * p.y() * p.y();
    sum.xz += w * p.x() * z;
    sum.yz += w * p.y() * z;
    sum.zz += w * z * z;
    sums_[i + 1] = sum;
  }
}

ArcMoments::Sums ArcMoments::between(Stretch places) const {
  const Sums& a = sums_[places.first - first_];
  const Sums& b = sums_[places.last - first_ + 1];
  return {b.w - a.w,   b.x - a.x,   b.y - a.y,   b.xx - a.xx, b.xy - a.xy,
          b.yy - a.yy, b.xz - a.xz, b.yz - a.yz, b.zz - a.zz};
}

double ArcMoments::chi2(Stretch places) const {
  constexpr double kNoArc = std::numeric_limits<double>::infinity();
  const Sums s = between(places);
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
  if ((mean - center).dot(center + origin_m_) >= 0.0) return kNoArc;
  const double radius2 = (center - mean).squaredNorm() + (z - mx * s.x - my * s.y) / s.w;
  return std::max(0.0, rest) / (4.0 * radius2);
}

}  // namespace scanbed
