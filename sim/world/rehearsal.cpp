// SPDX-License-Identifier: MIT
#include "sim/world/rehearsal.hpp"

#include "sim/world/crowd.hpp"
#include "sim/world/drive_plan.hpp"

namespace scanbed::sim {

std::optional<Collision> first_collision(const World& world, double duration_s) {
  constexpr int kLooks_per_s = 20;
  const Crowd crowd(world, world.robot.laser_height_m);
  const DrivePlan drive(world.robot);
  CollisionWatch watch(world);
  WorldState state;
  for (int look = 0; look <= duration_s * kLooks_per_s; ++look) {
    state.time_s = static_cast<double>(look) / kLooks_per_s;
    state.X_WR = drive.pose_at(state.time_s);
    crowd.states_at(state.time_s, state.walkers);
    watch.look(state);
    if (!watch.collisions().empty()) return watch.collisions().front();
  }
  return {};
}

}  // namespace scanbed::sim
