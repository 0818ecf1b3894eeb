// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "sim/world/drive_path.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// What a robot is told to do until it is told otherwise.
struct DriveCommand {
  double speed_m_per_s = 0.0;   ///< ahead
  double turn_rad_per_s = 0.0;  ///< counter-clockwise
};

/// A robot's pose as a function of time: its drive steps one after the other, each at constant speed, then it
/// stands still. While it follows legs it does what it was last commanded, and stands still before.
class DrivePlan {
 public:
  /// @pre the robot validates.
  explicit DrivePlan(const Robot& robot);

  /// X_WR; the start for time_s <= 0. @pre  time_s is not before the time of the last command but one.
  Pose2 pose_at(double time_s) const;

  double end_s() const { return legs_.back().start_s; }  ///< infinite where it follows legs for ever

  /// The step of following legs that is under way; nullptr where it is none.
  const FollowLegs* following_at(double time_s) const;

  /// Takes a command that holds from `from_s` on; ignored where no legs are followed then.
  /// @pre  from_s is not before that of the last command.
  void command(double from_s, const DriveCommand& command);

 private:
  /// A motion from where the one before ended.
  struct Leg {
    double start_s;
    Pose2 X_WR;  ///< at start_s
    Motion motion;
    std::size_t step;  ///< index of its drive step
  };

  void plan_from(std::size_t step, double start_s, const Pose2& X_WR);
  const Leg& leg_at(double time_s) const;

  Robot robot_;
  std::vector<Leg> legs_;  ///< the last one stands still for ever
  double last_command_s_ = 0.0;
};

/// @throws InputError naming the first drive step that cannot be.
void validate_drive(const Robot& robot);

}  // namespace scanbed::sim
