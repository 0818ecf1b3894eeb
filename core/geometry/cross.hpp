// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace scanbed {

/// Of the cross product the part that leaves the plane: positive where b lies to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace scanbed
