// SPDX-License-Identifier: MIT
#include <utility>

#include "scenarios/load/sections.hpp"
#include "sim/generate/random_world.hpp"

namespace scanbed::scenarios {

void load_generated(const Value& value, Scenario& scenario) {
  const auto kind = static_cast<sim::WorldKind>(value.choice(sim::world_kind_names()));
  sim::Robot& robot = scenario.world.robot;
  sim::World drawn = sim::random_world(kind, scenario.seed, robot.laser_height_m);
  drawn.robot.laser_pitch_rad = robot.laser_pitch_rad;
  drawn.robot.laser_roll_rad = robot.laser_roll_rad;
  scenario.world = std::move(drawn);
}

}  // namespace scanbed::scenarios
