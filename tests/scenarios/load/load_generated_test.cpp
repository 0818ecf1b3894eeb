// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "sim/generate/random_world.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

TEST(LoadGeneratedTest, DrawsTheWorldOfTheSeed) {
  const sim::World world = parse("seed: 7\ngenerate: rooms\n").world;
  const sim::World expected = sim::random_world(sim::WorldKind::kRooms, 7, 0.28);
  ASSERT_EQ(world.solids.size(), expected.solids.size());
  EXPECT_EQ(world.solids.back().id, expected.solids.back().id);
  EXPECT_EQ(world.robot.X_WR.p_m, expected.robot.X_WR.p_m);
}

TEST(LoadGeneratedTest, LeavesTheLasersMountAndLetsTheFileAddAndChange) {
  const sim::World world = parse(
                               "seed: 7\nsensor: {height: 0.4}\ngenerate: corridors\nrobot: {speed: 0.7}\n"
                               "world: [{id: far, cylinder: {at: [50, 50], r: 1}}]\n")
                               .world;
  EXPECT_EQ(world.robot.laser_height_m, 0.4);
  EXPECT_EQ(world.robot.speed_m_per_s, 0.7);
  EXPECT_FALSE(world.robot.drive.empty());
  EXPECT_EQ(world.solids.back().id, "far");
  EXPECT_GT(world.solids.size(), 1u);
}

TEST(LoadGeneratedTest, RefusesOtherKinds) {
  EXPECT_EQ(parse_error("generate: roms\n"), "f:4:11: generate: unknown value 'roms'; did you mean 'rooms'?");
}

}  // namespace
}  // namespace scanbed::scenarios
