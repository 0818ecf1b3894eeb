// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace scanbed::sim {

/// A walker at one moment, world frame.
struct WalkerState {
  int walker = 0;        ///< index into World::walkers
  bool present = false;  ///< false before its start and after it left
  Pose2 X_WP;            ///< pelvis, x axis along the direction of walking
  Eigen::Vector2d left_foot_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d right_foot_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d left_leg_m = Eigen::Vector2d::Zero();  ///< centre of the leg at the laser's height
  Eigen::Vector2d right_leg_m = Eigen::Vector2d::Zero();
};

/// A towed cylinder at one moment, world frame.
struct TowState {
  int walker = 0;  ///< who pulls it: index into World::walkers
  bool present = false;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
};

/// Everything that moves, at one moment. What an engine gives to pictures and to truth.
struct WorldState {
  double time_s = 0.0;
  Pose2 X_WR;                        ///< robot
  std::vector<WalkerState> walkers;  ///< as in World::walkers
  std::vector<TowState> tows;        ///< those walkers that tow, in their order
};

}  // namespace scanbed::sim
