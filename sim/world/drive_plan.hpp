// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// A robot's pose as a function of time: its drive steps one after the other, each at constant speed, then it
/// stands still.
class DrivePlan {
 public:
  /// @pre the robot validates.
  explicit DrivePlan(const Robot& robot);

  Pose2 pose_at(double time_s) const;  ///< X_WR; the start for time_s <= 0
  double end_s() const { return legs_.back().start_s; }

 private:
  struct Leg {
    double start_s;
    Pose2 X_WR;  ///< at start_s
    double speed_m_per_s;
    double turn_rad_per_s;
  };
  std::vector<Leg> legs_;  ///< the last one stands still for ever
};

}  // namespace scanbed::sim
