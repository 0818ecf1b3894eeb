// SPDX-License-Identifier: MIT
#include "sim/spatial/posed_mjcf.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sim/engine/make_engine.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "tests/support/hall.hpp"

namespace scanbed::sim {
namespace {

// As the engine's own poses say, at the start and later; of bodies and of what hangs on them.
TEST(PosedMjcfTest, AResetModelStandsAsTheWorldDid) {
  const World world = test_hall();
  const auto engine = make_engine(world, Backend::kPlanar);
  for (const double time_s : {0.0, 3.0}) {
    engine->advance_to(time_s);
    const ModelPtr model = load_model(posed_mjcf(world, engine->state()));
    const DataPtr data = make_data(*model);
    mj_forward(model.get(), data.get());
    const ModelPtr plain = load_model(mjcf_of(world));
    const DataPtr expected = make_data(*plain);
    pose_actors(world, engine->state(), *plain, *expected);
    ASSERT_EQ(model->ngeom, plain->ngeom);
    for (int i = 0; i < 3 * model->ngeom; ++i) {
      EXPECT_NEAR(data->geom_xpos[i], expected->geom_xpos[i], 1e-9) << time_s << " " << i / 3;
    }
    const int robot = mj_name2id(model.get(), mjOBJ_BODY, kRobotBody);
    EXPECT_NEAR(data->xpos[3 * robot], engine->state().X_WR.p_m.x(), 1e-9);
    EXPECT_NEAR(data->xpos[3 * robot + 1], engine->state().X_WR.p_m.y(), 1e-9);
  }
}

// More of them than what has no tow needs room for; each touches the floor.
TEST(PosedMjcfTest, HasRoomForTheContactsOfManyTowedCylinders) {
  constexpr int kNumTows = 60;
  World world;
  for (int i = 0; i < kNumTows; ++i) {
    Walker walker;
    walker.id = "w" + std::to_string(i);
    walker.path = {{{0.0, 2.0 * i}, {4.0, 2.0 * i}}, false, 0.0, false};
    walker.tow = Tow{};
    walker.tow->id = "cyl" + std::to_string(i);
    world.walkers.push_back(walker);
  }
  const auto engine = make_engine(world, Backend::kPlanar);
  const ModelPtr model = load_model(posed_mjcf(world, engine->state()));
  const DataPtr data = make_data(*model);
  for (int i = 0; i < 20; ++i) mj_step(model.get(), data.get());
  EXPECT_EQ(data->warning[mjWARN_CONTACTFULL].number, 0);
  EXPECT_EQ(data->warning[mjWARN_CNSTRFULL].number, 0);
  EXPECT_GE(data->ncon, 3 * kNumTows);
}

}  // namespace
}  // namespace scanbed::sim
