// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "sim/spatial/plane_cut.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// R_RS in space: the turn of X_RS, then pitch about the laser's own y axis, then roll about its own x axis.
inline Eigen::Matrix3d laser_turn(const Robot& robot) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const Eigen::Matrix3d yaw = AngleAxisd(robot.X_RS.theta_rad, Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d pitch = AngleAxisd(robot.laser_pitch_rad, Vector3d::UnitY()).toRotationMatrix();
  const Eigen::Matrix3d roll = AngleAxisd(robot.laser_roll_rad, Vector3d::UnitX()).toRotationMatrix();
  return yaw * pitch * roll;
}

/// The laser in space, on a robot at X_WR.
inline LaserPlane laser_plane(const Robot& robot, const Pose2& X_WR) {
  const Eigen::Vector2d p_WS = X_WR * robot.X_RS.p_m;
  const Eigen::Matrix3d R_WR = Eigen::AngleAxisd(X_WR.theta_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return {{p_WS.x(), p_WS.y(), robot.laser_height_m}, R_WR * laser_turn(robot)};
}

}  // namespace scanbed::sim
