// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/geometry/angles.hpp"

namespace scanbed {

/// Pose X_AB of frame B in frame A, in the plane: metres, radians counter-clockwise.
struct Pose2 {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();  ///< origin of B from A's origin, expressed in A
  double theta_rad = 0.0;                         ///< from A's x axis to B's x axis

  /// Direction (cos, sin) of B's x axis, in A.
  Eigen::Vector2d heading() const { return {std::cos(theta_rad), std::sin(theta_rad)}; }

  /// Rotates a vector given in B into A.
  Eigen::Vector2d rotate(const Eigen::Vector2d& v_B) const {
    const Eigen::Vector2d h = heading();
    return {h.x() * v_B.x() - h.y() * v_B.y(), h.y() * v_B.x() + h.x() * v_B.y()};
  }

  /// p_AQ = X_AB * p_BQ.
  Eigen::Vector2d operator*(const Eigen::Vector2d& p_BQ) const { return p_m + rotate(p_BQ); }

  /// X_AC = X_AB * X_BC.
  Pose2 operator*(const Pose2& X_BC) const {
    return {*this * X_BC.p_m, wrap_to_pi(theta_rad + X_BC.theta_rad)};
  }

  /// X_BA.
  Pose2 inverse() const {
    const Pose2 R_BA{Eigen::Vector2d::Zero(), -theta_rad};
    return {-R_BA.rotate(p_m), -theta_rad};
  }
};

}  // namespace scanbed
