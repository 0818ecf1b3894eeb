// SPDX-License-Identifier: MIT
#pragma once

#include "sim/world/crowd.hpp"
#include "sim/world/drive_plan.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// What a world's script says of robot and walkers, whatever the physics: every engine follows it exactly. A
/// robot that follows legs adds what it is commanded.
class WorldScript {
 public:
  /// @pre the world validates.
  explicit WorldScript(const World& world) : drive_(world.robot), crowd_(world, world.robot.laser_height_m) {
    for (const Walker& walker : world.walkers) has_tows_ = has_tows_ || walker.tow.has_value();
  }

  /// Writes time, robot and walkers; leaves the towed cylinders as they are, since those are physics.
  void follow(double time_s, WorldState& state) const {
    state.time_s = time_s;
    state.X_WR = drive_.pose_at(time_s);
    crowd_.states_at(time_s, state.walkers);
  }

  bool has_tows() const { return has_tows_; }

  DrivePlan& drive() { return drive_; }

 private:
  DrivePlan drive_;
  Crowd crowd_;
  bool has_tows_ = false;
};

}  // namespace scanbed::sim
