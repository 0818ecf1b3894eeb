// SPDX-License-Identifier: MIT
#include "sim/engine/make_engine.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"
#include "sim/planar/planar_engine.hpp"
#include "sim/spatial/spatial_engine.hpp"

namespace scanbed::sim {
namespace {

TEST(MakeEngineTest, NamesAndBackendsGoTogether) {
  EXPECT_EQ(to_string(Backend::kPlanar), "planar");
  EXPECT_EQ(to_string(Backend::kSpatial), "spatial");
  EXPECT_EQ(backend_names().size(), 2u);
}

TEST(MakeEngineTest, MakesTheEngineThatWasAskedFor) {
  EXPECT_NE(dynamic_cast<PlanarEngine*>(make_engine(World{}, Backend::kPlanar).get()), nullptr);
  EXPECT_NE(dynamic_cast<SpatialEngine*>(make_engine(World{}, Backend::kSpatial).get()), nullptr);
}

TEST(MakeEngineTest, OnlyTheSpatialEngineTakesATiltedLaser) {
  World world;
  world.robot.laser_pitch_rad = 0.2;
  EXPECT_THROW(make_engine(world, Backend::kPlanar), InputError);
  EXPECT_NO_THROW(make_engine(world, Backend::kSpatial));
}

}  // namespace
}  // namespace scanbed::sim
