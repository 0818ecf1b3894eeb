// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/world/drive_plan.hpp"
#include "sim/world/gait.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// What a world's script says of robot and walkers, whatever the physics: every engine follows it exactly.
class WorldScript {
 public:
  /// @pre the world validates.
  explicit WorldScript(const World& world) : drive_(world.robot) {
    for (std::size_t i = 0; i < world.walkers.size(); ++i) {
      gaits_.emplace_back(world.walkers[i], static_cast<int>(i), world.robot.laser_height_m);
      has_tows_ = has_tows_ || world.walkers[i].tow.has_value();
    }
  }

  /// Writes time, robot and walkers; leaves the towed cylinders as they are, since those are physics.
  void follow(double time_s, WorldState& state) const {
    state.time_s = time_s;
    state.X_WR = drive_.pose_at(time_s);
    state.walkers.resize(gaits_.size());
    for (std::size_t i = 0; i < gaits_.size(); ++i) state.walkers[i] = gaits_[i].state_at(time_s);
  }

  bool has_tows() const { return has_tows_; }

 private:
  DrivePlan drive_;
  std::vector<Gait> gaits_;
  bool has_tows_ = false;
};

}  // namespace scanbed::sim
