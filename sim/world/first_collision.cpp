// SPDX-License-Identifier: MIT
#include "sim/world/first_collision.hpp"

#include "sim/world/world_script.hpp"

namespace scanbed::sim {

std::optional<Collision> first_collision(const World& world, double duration_s) {
  const WorldScript script(world);
  CollisionWatch watch(world);
  WorldState state;
  for (int look = 0; look * kBetweenLooks_s <= duration_s; ++look) {
    script.follow(look * kBetweenLooks_s, state);
    watch.look(state);
    if (!watch.collisions().empty()) return watch.collisions().front();
  }
  return {};
}

}  // namespace scanbed::sim
