// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <algorithm>

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

RayLineSums::Sums RayLineSums::between(int first, int last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  return {b.q - a.q, b.qx - a.qx, b.qy - a.qy, b.qxx - a.qxx, b.qxy - a.qxy, b.qyy - a.qyy};
}

RayLine RayLineSums::solve(const Sums& s) {
  const double determinant = s.qxx * s.qyy - s.qxy * s.qxy;
  if (determinant <= 0.0) return {};
  RayLine line;
  line.inverse_m = Eigen::Vector2d(s.qyy * s.qx - s.qxy * s.qy, s.qxx * s.qy - s.qxy * s.qx) / determinant;
  line.chi2 = std::max(0.0, s.q - line.inverse_m.x() * s.qx - line.inverse_m.y() * s.qy);
  return line;
}

RayLine RayLineSums::fit(Stretch places) const {
  return solve(between(places.first, places.last));
}

double RayLineSums::explained_by_two(Stretch places, int split) const {
  using Lanes = Eigen::Array2d;  // before the split, after it
  const Sums a = between(places.first, split);
  const Sums b = between(split + 1, places.last);
  const Lanes q(a.q, b.q);
  const Lanes qx(a.qx, b.qx);
  const Lanes qy(a.qy, b.qy);
  const Lanes qxx(a.qxx, b.qxx);
  const Lanes qxy(a.qxy, b.qxy);
  const Lanes qyy(a.qyy, b.qyy);
  const Lanes determinant = qxx * qyy - qxy * qxy;
  const Lanes explained = (qyy * qx * qx - 2.0 * qxy * qx * qy + qxx * qy * qy) / determinant;
  // A line explains one echo wholly; there, and where all lie at one place, the quotient says nothing.
  const auto share = [&](int lane, bool is_single) {
    return is_single || !(determinant[lane] > 0.0 && explained[lane] < q[lane]) ? q[lane] : explained[lane];
  };
  return share(0, split == places.first) + share(1, split + 1 == places.last);
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
