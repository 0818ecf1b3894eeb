// SPDX-License-Identifier: MIT
#include "bench/support/hall_world.hpp"

namespace scanbed::bench {

sim::World hall_world() {
  sim::World world;
  world.solids.push_back(
      {.id = "hall", .label = "wall", .shape = sim::WallChain{{{-7, 0}, {7, 0}, {7, 9}, {-7, 9}}, true}});
  for (int i = 0; i < 6; ++i) {  // with the hall's 4 walls and two legs: 4 + 6 + 6 * 4 + 2 = 36 shapes
    const std::string number = std::to_string(i);
    world.solids.push_back(
        {.id = "column" + number, .label = "column", .shape = sim::Cylinder{{-5.0 + 2.0 * i, 4.0}, 0.25}});
    world.solids.push_back({.id = "pillar" + number,
                            .label = "box",
                            .shape = sim::Box{{{-4.0 + 1.8 * i, 6.5}, 0.3 * i}, {0.3, 0.3}}});
  }
  world.walkers.push_back({.id = "walker", .path = {.points_m = {{-3.0, 2.5}, {3.0, 2.5}}, .loop = true}});
  world.robot.X_WR = {{0.0, 0.45}, kPi / 2};
  return world;
}

}  // namespace scanbed::bench
