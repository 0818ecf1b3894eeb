// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {

void RayLineSums::build(const Echoes& echoes, const std::vector<int>& order) {
  sums_.resize(order.size() + 1);
  Sums sum;
  sums_[0] = sum;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int k = order[i];
    const double c = echoes.ux[k];
    const double s = echoes.uy[k];
    const double r2 = echoes.range_m[k] * echoes.range_m[k];
    // An error dr of range is an error dr / r2 of its inverse.
    const double weight = r2 * r2 / (echoes.sigma_m[k] * echoes.sigma_m[k]);
    const double y = 1.0 / echoes.range_m[k];
    sum.cc += weight * c * c;
    sum.cs += weight * c * s;
    sum.ss += weight * s * s;
    sum.cy += weight * c * y;
    sum.sy += weight * s * y;
    sum.yy += weight * y * y;
    sums_[i + 1] = sum;
  }
}

RayLineSums::Sums RayLineSums::between(int first, int last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  return {b.cc - a.cc, b.cs - a.cs, b.ss - a.ss, b.cy - a.cy, b.sy - a.sy, b.yy - a.yy};
}

RayLine RayLineSums::solve(const Sums& s) {
  const double determinant = s.cc * s.ss - s.cs * s.cs;
  if (determinant <= 0.0) return {};
  RayLine line;
  line.inverse_m = Eigen::Vector2d(s.ss * s.cy - s.cs * s.sy, s.cc * s.sy - s.cs * s.cy) / determinant;
  line.chi2 = std::max(0.0, s.yy - line.inverse_m.x() * s.cy - line.inverse_m.y() * s.sy);
  return line;
}

RayLine RayLineSums::fit(int first, int last) const {
  return solve(between(first, last));
}

double RayLineSums::chi2(int first, int last) const {
  const Sums s = between(first, last);
  const double determinant = s.cc * s.ss - s.cs * s.cs;
  if (determinant <= 0.0) return 0.0;
  const double explained = s.ss * s.cy * s.cy - 2.0 * s.cs * s.cy * s.sy + s.cc * s.sy * s.sy;
  return std::max(0.0, s.yy - explained / determinant);
}

RayLine RayLineSums::fit_both(Stretch a, Stretch b) const {
  Sums sums = between(a.first, a.last);
  const Sums other = between(b.first, b.last);
  sums.cc += other.cc;
  sums.cs += other.cs;
  sums.ss += other.ss;
  sums.cy += other.cy;
  sums.sy += other.sy;
  sums.yy += other.yy;
  return solve(sums);
}

}  // namespace scanbed
