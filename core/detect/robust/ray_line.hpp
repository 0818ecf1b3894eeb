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

/// Sums from which the line through any run of echoes is fitted in constant time.
class RayLineSums {
 public:
  /// Takes the echoes in the given order.
  void build(const Echoes& echoes, const std::vector<int>& order);

  /// Weighted least squares over places [first, last] of the order. @pre last > first.
  RayLine fit(int first, int last) const;

  /// Of that fit.
  double chi2(int first, int last) const;

  /// One line through both.
  RayLine fit_both(Stretch a, Stretch b) const;

 private:
  struct Sums {
    double cc = 0, cs = 0, ss = 0, cy = 0, sy = 0, yy = 0;
  };
  Sums between(int first, int last) const;
  static RayLine solve(const Sums& sums);

  std::vector<Sums> sums_;
};

}  // namespace scanbed
