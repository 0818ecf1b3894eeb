// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

#include "core/errors/sensor_fault.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/part_names.hpp"
#include "tests/support/hall.hpp"

namespace scanbed::sim {
namespace {

int geom_id(const mjModel& model, const std::string& name) {
  return mj_name2id(&model, mjOBJ_GEOM, name.c_str());
}

World one_column(const std::string& id) {
  World world;
  world.solids = {{.id = id, .label = "column", .shape = Cylinder{{2, 3}, 0.25}}};
  return world;
}

TEST(MjcfTest, TheHallBecomesAModelWithEveryThingInIt) {
  const ModelPtr model = load_model(mjcf_of(test_hall()));
  for (int wall = 0; wall < 4; ++wall) EXPECT_GE(geom_id(*model, solid_name("hall", wall)), 0);
  for (const char* id : {"col_L", "col_R", "bench_L.foot_0", "bench_L.seat", "bench_R.seat"}) {
    EXPECT_GE(geom_id(*model, solid_name(id, 0)), 0) << id;
  }
  EXPECT_EQ(model->ntendon, 1);
  EXPECT_EQ(model->nmocap, 1 + 2 * 7);  // robot, two walkers of seven parts
  EXPECT_EQ(model->nv, 3 + 3);          // the cylinder, and its rope's other end
}

TEST(MjcfTest, AnEmptyWorldIsAFloorAndARobot) {
  const ModelPtr model = load_model(mjcf_of(World{}));
  EXPECT_GE(geom_id(*model, kFloorGeom), 0);
  EXPECT_EQ(model->nmocap, 1);
}

TEST(MjcfTest, FloorTilesAreOneMetreAndBeginAtWholeCoordinates) {
  const ModelPtr model = load_model(mjcf_of(test_hall()));
  const int floor = geom_id(*model, kFloorGeom);
  for (int axis = 0; axis < 2; ++axis) {
    const double half_m = model->geom_size[3 * floor + axis];
    const double least_m = model->geom_pos[3 * floor + axis] - half_m;
    EXPECT_EQ(least_m, std::round(least_m));
    // A texture of two by two tiles, laid out this many times over the whole width.
    const int material = model->geom_matid[floor];
    EXPECT_EQ(2.0 * model->mat_texrepeat[2 * material + axis], 2.0 * half_m);
  }
}

TEST(MjcfTest, EveryKindOfSolidCompiles) {
  World world;
  world.solids = {{.id = "chain", .shape = WallChain{{{0, 0}, {3, 0}}}},
                  {.id = "box", .shape = Box{{{1, 1}, 0.3}, {1, 2}}},
                  {.id = "prism", .shape = Polygon{{{4, 4}, {6, 4}, {5, 6}}}}};
  const ModelPtr model = load_model(mjcf_of(world));
  EXPECT_EQ(model->geom_type[geom_id(*model, solid_name("chain", 0))], mjGEOM_BOX);
  EXPECT_EQ(model->geom_type[geom_id(*model, solid_name("box", 0))], mjGEOM_BOX);
  EXPECT_EQ(model->geom_type[geom_id(*model, solid_name("prism", 0))], mjGEOM_MESH);
}

TEST(MjcfTest, OddIdsAreKept) {
  for (const std::string id : {"a\"b", "a'b", "a<b>", "a&b", "&amp;", "]]>", "<!--", "", " ",
                               "  two  blanks ", "Säule", "柱", "a/0", "\xff\xfe", "tab\there"}) {
    const ModelPtr model = load_model(mjcf_of(one_column(id)));
    EXPECT_GE(geom_id(*model, solid_name(id, 0)), 0) << id;
  }
}

TEST(MjcfTest, AnyIdIsKept) {
  rc::check([](const std::string& id) {
    const ModelPtr model = load_model(mjcf_of(one_column(id)));
    RC_ASSERT(geom_id(*model, solid_name(id, 0)) >= 0);
  });
}

TEST(MjcfTest, AVeryLongIdIsNoProblem) {
  const std::string id(20000, 'x');
  try {
    const ModelPtr model = load_model(mjcf_of(one_column(id)));
    EXPECT_GE(geom_id(*model, solid_name(id, 0)), 0);
  } catch (const SensorFault& fault) {
    EXPECT_LT(std::string(fault.what()).size(), 2000U);
  }
}

TEST(MjcfTest, EqualIdsAreRefusedByName) {
  World world = one_column("twin");
  world.solids.push_back(world.solids.front());
  try {
    load_model(mjcf_of(world));
    FAIL() << "two geoms of one name";
  } catch (const SensorFault& fault) {
    EXPECT_NE(std::string(fault.what()).find("solid/twin/0"), std::string::npos) << fault.what();
  }
}

}  // namespace
}  // namespace scanbed::sim
