// SPDX-License-Identifier: MIT
#include "sim/world/check_places.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/errors/input_error.hpp"
#include "tests/sim/world/made_solid.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using testing::made_solid;

std::string error_of(const World& world) {
  try {
    check_places(world);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

World world_of(const std::vector<Solid>& solids) {
  World world;
  world.solids = solids;
  world.robot.X_WR = {{-5, 0}, 0.0};
  return world;
}

const SolidShape kBox = Box{{{3, 0}, 0.2}, {2, 1}};
const SolidShape kWedge = Polygon{{{2, -1}, {4, -1}, {3, 1}}};
const SolidShape kColumn = Cylinder{{3, 0}, 1};

TEST(CheckPlacesTest, RefusesWhatLiesWhollyWithinAnotherOfAnyShape) {
  const std::vector<SolidShape> small = {Cylinder{{3, 0}, 0.1}, Box{{{3, 0}, 1.0}, {0.1, 0.1}},
                                         Polygon{{{2.9, 0}, {3.1, 0}, {3, 0.1}}},
                                         WallChain{{{2.9, 0}, {3.1, 0.1}}, false}};
  for (const SolidShape& outer : {kBox, kWedge, kColumn}) {
    for (const SolidShape& inner : small) {
      const std::string expected =
          "solid 'in': lies wholly within solid 'out'; allowed: at least partly outside";
      EXPECT_EQ(error_of(world_of({made_solid("in", inner), made_solid("out", outer)})), expected);
      EXPECT_EQ(error_of(world_of({made_solid("out", outer), made_solid("in", inner)})), expected);
    }
  }
}

TEST(CheckPlacesTest, RefusesTheSameShapeTwice) {
  for (const SolidShape& shape : {kBox, kWedge, kColumn}) {
    EXPECT_NE(error_of(world_of({made_solid("a", shape), made_solid("b", shape)})), "");
  }
}

TEST(CheckPlacesTest, TouchingFromInsideIsWithin) {
  EXPECT_NE(error_of(world_of(
                {made_solid("a", Box{{{0, 0}, 0}, {2, 2}}), made_solid("b", Cylinder{{0.5, 0}, 0.5})})),
            "");
  EXPECT_NE(
      error_of(world_of({made_solid("a", Cylinder{{0, 0}, 1}), made_solid("b", Cylinder{{0.5, 0}, 0.5})})),
      "");
}

TEST(CheckPlacesTest, WhatOnlyOverlapsTouchesOrIsWalledInIsFine) {
  EXPECT_EQ(error_of(world_of({made_solid("a", kBox), made_solid("b", Box{{{3, 0}, 1.5}, {2, 1}})})), "");
  EXPECT_EQ(error_of(world_of({made_solid("a", kColumn), made_solid("b", Cylinder{{5, 0}, 1})})), "");
  EXPECT_EQ(error_of(world_of({made_solid("a", kBox), made_solid("b", WallChain{{{3, 0}, {9, 0}}, false})})),
            "");
  const WallChain walls{{{0, -3}, {6, -3}, {6, 3}, {0, 3}}, true};
  World world = world_of({made_solid("walls", walls), made_solid("a", kBox), made_solid("same", walls)});
  world.robot.X_WR = {{0.5, 0}, 0.0};
  EXPECT_EQ(error_of(world), "");
}

// A seat on its feet, a bin under a table.
TEST(CheckPlacesTest, WhatReachesHigherOrLowerIsNotWithin) {
  EXPECT_EQ(error_of(world_of(
                {made_solid("seat", kBox, 0.45, 0.5), made_solid("foot", Cylinder{{3, 0}, 0.1}, 0, 0.45)})),
            "");
  EXPECT_NE(
      error_of(world_of({made_solid("out", kBox, 0, 1), made_solid("in", Cylinder{{3, 0}, 0.1}, 0, 1)})), "");
}

TEST(CheckPlacesTest, RefusesARobotOutsideTheWallsAroundEverythingElse) {
  const WallChain hall{{{0, -3}, {9, -3}, {9, 3}, {4, 3}, {4, 1}, {0, 1}}, true};
  World world = world_of({made_solid("hall", hall), made_solid("column", Cylinder{{7, 0}, 0.3})});
  const std::string expected =
      "robot: start: is outside solid 'hall', which encloses everything else; allowed: inside";
  EXPECT_EQ(error_of(world), expected);
  world.robot.X_WR.p_m = {2, 2};  // in its recess
  EXPECT_EQ(error_of(world), expected);
  world.robot.X_WR.p_m = {2, 0};
  EXPECT_EQ(error_of(world), "");
  // Something is outside as well, or there is nothing but walls.
  world.robot.X_WR.p_m = {-5, 0};
  world.solids[1].shape = Cylinder{{2, 2}, 0.3};
  EXPECT_EQ(error_of(world), "");
  world.solids.pop_back();
  EXPECT_EQ(error_of(world), "");
  Walker walker;
  walker.id = "anna";
  walker.path.points_m = {{1, 0}, {8, 0}};
  world.walkers = {walker};
  EXPECT_EQ(error_of(world), expected);
}

// A map of a room with thick walls and a block in it: outlines have matter to their left.
TEST(CheckPlacesTest, NobodyStartsInWhatAMapFills) {
  const WallChain outer{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true, true};
  const WallChain room{{{1, 1}, {1, 9}, {9, 9}, {9, 1}}, true, true};
  const WallChain block{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, true, true};
  World world = world_of({made_solid("map.0", outer), made_solid("map.1", room), made_solid("map.2", block)});
  const auto error_at = [&](const Vector2d& start_m) {
    world.robot.X_WR = {start_m, 0.0};
    return error_of(world);
  };
  EXPECT_EQ(error_at({0.5, 5}), "robot: start: is in what solid 'map.0' fills; allowed: in the free");
  EXPECT_EQ(error_at({5, 5}), "robot: start: is in what solid 'map.2' fills; allowed: in the free");
  EXPECT_EQ(error_at({2, 5}), "");
  Walker walker;
  walker.id = "anna";
  walker.path.points_m = {{5, 5}, {2, 2}};
  world.walkers = {walker};
  EXPECT_EQ(error_at({2, 5}),
            "walker 'anna': start of its path: is in what solid 'map.2' fills; allowed: in the free");
}

TEST(CheckPlacesTest, NobodyStartsInASolid) {
  World world = world_of({made_solid("a", kBox)});
  world.robot.X_WR.p_m = {3, 0};
  EXPECT_EQ(error_of(world).substr(0, 40), "robot: start: distance to solid 'a': val");
  world.robot.X_WR.p_m = {-5, 0};
  Walker walker;
  walker.id = "anna";
  walker.path.points_m = {{3, 0}, {8, 0}};
  world.walkers = {walker};
  EXPECT_EQ(error_of(world).substr(0, 40), "walker 'anna': start of its path: distan");
}

}  // namespace
}  // namespace scanbed::sim
