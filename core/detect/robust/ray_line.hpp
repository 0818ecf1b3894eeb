// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// A straight wall as rays see it: 1 / range = a cos(bearing) + b sin(bearing), linear in its parameters.
struct RayLine {
  Eigen::Vector2d inverse_m = Eigen::Vector2d::Zero();  ///< (a, b): normal of the wall / its distance
  double chi2 = 0.0;  ///< sum of squared range residuals in units of their sigma
};

/// Sums from which the line through any stretch of echoes is fitted in constant time.
///
/// An error dr of range is an error dr / r^2 of its inverse; so a point (x, y) at range r with sigma s adds
/// q (a x + b y - 1)^2 with q = (r / s)^2.
class RayLineSums {
 public:
  void build(const Echoes& echoes);

  /// Weighted least squares over a stretch of at least two echoes.
  RayLine fit(Stretch places) const;

  /// How much of the sum of q the lines through [places.first, split] and [split + 1, places.last] explain:
  /// the more, the less chi squared they leave. @pre  first <= split < last.
  double explained_by_two(Stretch places, int split) const;

  /// One line through both.
  RayLine fit_both(Stretch a, Stretch b) const;

 private:
  struct Sums {
    double q = 0, qx = 0, qy = 0, qxx = 0, qxy = 0, qyy = 0;
  };
  Sums between(int first, int last) const;
  static RayLine solve(const Sums& sums);

  std::vector<Sums> sums_;  ///< over the echoes before each, and over all
};

// Here for the inner loops that cut surfaces into lines.

inline RayLineSums::Sums RayLineSums::between(int first, int last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  return {b.q - a.q, b.qx - a.qx, b.qy - a.qy, b.qxx - a.qxx, b.qxy - a.qxy, b.qyy - a.qyy};
}

inline RayLine RayLineSums::solve(const Sums& s) {
  const double determinant = s.qxx * s.qyy - s.qxy * s.qxy;
  if (determinant <= 0.0) return {};
  RayLine line;
  line.inverse_m = Eigen::Vector2d(s.qyy * s.qx - s.qxy * s.qy, s.qxx * s.qy - s.qxy * s.qx) / determinant;
  line.chi2 = std::max(0.0, s.q - line.inverse_m.x() * s.qx - line.inverse_m.y() * s.qy);
  return line;
}

inline RayLine RayLineSums::fit(Stretch places) const {
  return solve(between(places.first, places.last));
}

inline double RayLineSums::explained_by_two(Stretch places, int split) const {
  using Lanes = Eigen::Array2d;  // before the split, after it
  const Sums& first = sums_[places.first];
  const Sums& middle = sums_[split + 1];
  const Sums& last = sums_[places.last + 1];
  const auto both = [&](double Sums::*sum) {
    return Lanes(middle.*sum - first.*sum, last.*sum - middle.*sum);
  };
  const Lanes q = both(&Sums::q);
  const Lanes qx = both(&Sums::qx);
  const Lanes qy = both(&Sums::qy);
  const Lanes qxx = both(&Sums::qxx);
  const Lanes qxy = both(&Sums::qxy);
  const Lanes qyy = both(&Sums::qyy);
  const Lanes determinant = qxx * qyy - qxy * qxy;
  Lanes explained = ((qyy * qx - qxy * qy) * qx + (qxx * qy - qxy * qx) * qy) / determinant;
  explained = explained.min(q);
  // A line explains a single echo wholly; the quotient says nothing there.
  if (split == places.first) explained[0] = q[0];
  if (split + 1 == places.last) explained[1] = q[1];
  return explained.sum();
}

}  // namespace scanbed
