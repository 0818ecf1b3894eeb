// SPDX-License-Identifier: MIT
#include "sim/spatial/world_bounds.hpp"

#include <gtest/gtest.h>

namespace scanbed::sim {
namespace {

void expect_box(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
  EXPECT_LT((box.min() - least).norm(), 1e-12) << box.min().transpose();
  EXPECT_LT((box.max() - most).norm(), 1e-12) << box.max().transpose();
}

Solid solid(const SolidShape& shape) {
  return {.id = "x", .shape = shape, .top_m = 3.0};
}

TEST(WorldBoundsTest, HoldsEveryShape) {
  World world;
  world.solids = {solid(WallChain{{{-7, 1}, {2, 9}}}), solid(Cylinder{{5, 5}, 1.5}),
                  // Turned by a right angle: 4 m along y.
                  solid(Box{{{0, -3}, kPi / 2}, {4, 1}}), solid(Polygon{{{8, 0}, {9, 1}, {7, 2}}})};
  expect_box(world_bounds(world), {-7, -5, 0}, {9, 9, 3});
}

TEST(WorldBoundsTest, HoldsWalkersAndTheRobot) {
  World world;
  world.robot.X_WR = {{-4, 0}, 0.0};
  world.walkers = {{.id = "a", .path = {{{0, 0}, {6, 8}}}, .height_m = 1.9}};
  expect_box(world_bounds(world), {-4.22, -0.3, 0}, {6.3, 8.3, 1.9});
}

TEST(WorldBoundsTest, AnEmptyWorldIsTwoMetresAboutTheRobot) {
  World world;
  world.robot.X_WR = {{3, 4}, 1.0};
  expect_box(world_bounds(world), {2, 3, 0}, {4, 5, 1});
}

}  // namespace
}  // namespace scanbed::sim
