// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_moments.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {

void ArcMoments::begin(const Echoes& echoes) {
  echoes_ = &echoes;
  if (sums_.size() < echoes.beam.size()) sums_.resize(echoes.size());
  summed_ = {0, -1};
}

ArcMoments::Sums ArcMoments::plus(Sums sums, int place) const {
  const double x = echoes_->x_m[place];
  const double y = echoes_->y_m[place];
  const double w = echoes_->weight_per_m2[place];
  const double z = x * x + y * y;
  const double wx = w * x;
  const double wy = w * y;
  sums.w += w;
  sums.x += wx;
  sums.y += wy;
  sums.xx += wx * x;
  sums.xy += wx * y;
  sums.yy += wy * y;
  sums.xz += wx * z;
  sums.yz += wy * z;
  sums.zz += w * z * z;
  return sums;
}

ArcMoments::Sums ArcMoments::difference(const Sums& a, const Sums& b) {
  return {b.x - a.x,   b.y - a.y,   b.w - a.w,   b.xx - a.xx, b.xy - a.xy,
          b.yy - a.yy, b.xz - a.xz, b.yz - a.yz, b.zz - a.zz};
}

void ArcMoments::sum_up(Stretch places) {
  if (places.first < summed_.first || places.first > summed_.last) summed_ = {places.first, places.first - 1};
  Sums sums = summed_.size() > 0 ? sums_[summed_.last] : Sums{};
  while (summed_.last < places.last) {
    sums = plus(sums, ++summed_.last);
    sums_[summed_.last] = sums;
  }
}

std::optional<AlgebraicArc> ArcMoments::arc(Stretch places) {
  sum_up(places);
  if (places.first == summed_.first) return solve(sums_[places.last]);
  return solve(difference(sums_[places.first - 1], sums_[places.last]));
}

std::optional<AlgebraicArc> ArcMoments::arc_of_both(Stretch a, Stretch b) const {
  Sums sums;
  for (const Stretch& places : {a, b}) {
    for (int i = places.first; i <= places.last; ++i) sums = plus(sums, i);
  }
  return solve(sums);
}

std::optional<AlgebraicArc> ArcMoments::solve(const Sums& s) {
  const double per_weight = 1.0 / s.w;
  const double mx = s.x * per_weight;
  const double my = s.y * per_weight;
  const double z = s.xx + s.yy;
  const double xx = s.xx - mx * s.x;
  const double xy = s.xy - mx * s.y;
  const double yy = s.yy - my * s.y;
  const double xz = s.xz - mx * z;
  const double yz = s.yz - my * z;
  const double zz = s.zz - z * z * per_weight;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return std::nullopt;
  // z + d x + e y + f = 0 with least squared sum.
  const double d = -(yy * xz - xy * yz) / determinant;
  const double e = -(xx * yz - xy * xz) / determinant;
  const double rest = zz + d * xz + e * yz;
  const Eigen::Vector2d center(-0.5 * d, -0.5 * e);
  const Eigen::Vector2d mean(mx, my);
  if ((mean - center).dot(center) >= 0.0) return std::nullopt;
  const double radius2 = (center - mean).squaredNorm() + (z - mx * s.x - my * s.y) * per_weight;
  return AlgebraicArc{{center, std::sqrt(radius2)}, std::max(0.0, rest) / (4.0 * radius2)};
}

}  // namespace scanbed
