// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace scanbed {

/// Sums over points from which a line is fitted. Of two running sums, the difference belongs to the points in
/// between.
struct LineMoments {
  double num_points = 0.0;
  double x = 0.0, y = 0.0;              ///< sums, m
  double xx = 0.0, xy = 0.0, yy = 0.0;  ///< sums, m2

  void add(double x_m, double y_m);
  friend LineMoments operator-(const LineMoments& a, const LineMoments& b);
};

/// The line with the least sum of squared orthogonal distances.
struct LineFit {
  Eigen::Vector2d centroid_m;  ///< the line passes through it
  Eigen::Vector2d direction;   ///< unit vector along the line; its sign means nothing

  double distance_m(const Eigen::Vector2d& p_m) const {
    const Eigen::Vector2d from_centroid_m = p_m - centroid_m;
    return std::abs(from_centroid_m.x() * direction.y() - from_centroid_m.y() * direction.x());
  }
  /// The point of the line nearest to p.
  Eigen::Vector2d foot_of(const Eigen::Vector2d& p_m) const {
    return centroid_m + direction * direction.dot(p_m - centroid_m);
  }
};

/// Orthogonal regression: the principal direction of the points. Points that all coincide give direction (1,
/// 0).
///
/// @pre moments.num_points >= 1.
LineFit fit_line(const LineMoments& moments);

}  // namespace scanbed
