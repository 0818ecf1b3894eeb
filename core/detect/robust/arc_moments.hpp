// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// Sums over one surface from which the chi squared of a circle through any stretch of it follows in constant
/// time: quick to say what is no arc.
class ArcMoments {
 public:
  void build(const Echoes& echoes, const std::vector<int>& order, Stretch surface);

  /// Chi squared of range of the circle that fits the stretch best in algebraic distance.
  ///
  /// Off the least in geometric distance by a factor of a few at most; infinite where the points lie on a
  /// line or on a hollow as the sensor sees it.
  /// @pre  places lie within the surface of the last build.
  double chi2(Stretch places) const;

 private:
  struct Sums {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;  // z = x^2 + y^2
  };
  Sums between(Stretch places) const;

  std::vector<Sums> sums_;
  int first_ = 0;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();  // of the sums: the first point of the surface
};

}  // namespace scanbed
