// SPDX-License-Identifier: MIT
#include "sim/render/cutaway.hpp"

#include <gtest/gtest.h>

#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/part_names.hpp"
#include "tests/support/hall.hpp"

namespace scanbed::sim {
namespace {

double top_m(const mjModel& model, const std::string& geom) {
  const int id = mj_name2id(&model, mjOBJ_GEOM, geom.c_str());
  return model.geom_pos[3 * id + 2] + model.geom_size[3 * id + 2];
}

TEST(CutawayTest, OnlyTheWallsBeforeTheCameraAreLowered) {
  const World world = test_hall();
  const ModelPtr model = load_model(mjcf_of(world));
  // From the south-west, outside: the walls y = 0 (the first) and x = -7 (the fourth) are in the way.
  cut_away_walls(world, {-12, -8}, {0, 4.5}, *model);
  EXPECT_NEAR(top_m(*model, solid_name("hall", 0)), 0.1, 1e-12);
  EXPECT_NEAR(top_m(*model, solid_name("hall", 1)), 2.5, 1e-12);
  EXPECT_NEAR(top_m(*model, solid_name("hall", 2)), 2.5, 1e-12);
  EXPECT_NEAR(top_m(*model, solid_name("hall", 3)), 0.1, 1e-12);
}

TEST(CutawayTest, ColumnsAndBenchesStay) {
  const World world = test_hall();
  const ModelPtr model = load_model(mjcf_of(world));
  cut_away_walls(world, {0, -20}, {0, 4.5}, *model);
  EXPECT_NEAR(top_m(*model, solid_name("bench_L.seat", 0)), 0.48, 1e-12);
}

TEST(CutawayTest, AWallLowerThanTheKerbKeepsItsHeight) {
  World world;
  world.solids = {{.id = "sill", .shape = WallChain{{{-1, 0}, {1, 0}}}, .bottom_m = 0.5, .top_m = 0.54}};
  const ModelPtr model = load_model(mjcf_of(world));
  cut_away_walls(world, {0, -5}, {0, 5}, *model);
  EXPECT_NEAR(top_m(*model, solid_name("sill", 0)), 0.54, 1e-12);
}

}  // namespace
}  // namespace scanbed::sim
