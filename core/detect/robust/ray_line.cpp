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

RayLine RayLineSums::fit(int first, int last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  const double cc = b.cc - a.cc;
  const double cs = b.cs - a.cs;
  const double ss = b.ss - a.ss;
  const double cy = b.cy - a.cy;
  const double sy = b.sy - a.sy;
  const double yy = b.yy - a.yy;
  const double determinant = cc * ss - cs * cs;
  if (determinant <= 0.0) return {};
  RayLine line;
  line.inverse_m = Eigen::Vector2d(ss * cy - cs * sy, cc * sy - cs * cy) / determinant;
  line.chi2 = std::max(0.0, yy - line.inverse_m.x() * cy - line.inverse_m.y() * sy);
  return line;
}

}  // namespace scanbed
