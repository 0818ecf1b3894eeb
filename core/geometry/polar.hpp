// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace scanbed {

/// The point at a distance from the origin, counter-clockwise from the x axis.
inline Eigen::Vector2d polar(double bearing_rad, double distance_m) {
  return distance_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
}

}  // namespace scanbed
