// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
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

}  // namespace scanbed
