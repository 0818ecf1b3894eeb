// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

namespace scanbed {

void RayLineSums::build(const Echoes& echoes) {
  const int num_echoes = echoes.size();
  sums_.resize(num_echoes + 1);
  Sums sum;
  sums_[0] = sum;
  for (int k = 0; k < num_echoes; ++k) {
    const double x = echoes.x_m[k];
    const double y = echoes.y_m[k];
    const double q = echoes.weight_per_m2[k] * (echoes.range_m[k] * echoes.range_m[k]);
    const double qx = q * x;
    const double qy = q * y;
    sum.q += q;
    sum.qx += qx;
    sum.qy += qy;
    sum.qxx += qx * x;
    sum.qxy += qx * y;
    sum.qyy += qy * y;
    sums_[k + 1] = sum;
  }
}

RayLine RayLineSums::fit_both(Stretch a, Stretch b) const {
  Sums sums = between(a.first, a.last);
  const Sums other = between(b.first, b.last);
  sums.q += other.q;
  sums.qx += other.qx;
  sums.qy += other.qy;
  sums.qxx += other.qxx;
  sums.qxy += other.qxy;
  sums.qyy += other.qyy;
  return solve(sums);
}

}  // namespace scanbed
