// SPDX-License-Identifier: MIT
#include "sim/world/first_collision.hpp"

#include <gtest/gtest.h>

#include "sim/world/gait.hpp"

namespace scanbed::sim {
namespace {

Walker walker(const std::string& id, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  Walker made;
  made.id = id;
  made.path.points_m = {from_m, to_m};
  return made;
}

Solid wall_at(double x_m) {
  return {.id = "wall", .label = "wall", .shape = WallChain{{{x_m, -1}, {x_m, 1}}, false}};
}

TEST(FirstCollisionTest, NothingCollidesWhereAllKeepApart) {
  World world;
  world.robot.X_WR.p_m = {0, -5};
  world.walkers = {walker("ann", {0, 0}, {8, 0}), walker("ben", {8, 1}, {0, 1})};
  EXPECT_FALSE(first_collision(world, 10.0));
}

TEST(FirstCollisionTest, TheRobotReachesAWallWhereItsRadiusTouches) {
  World world;
  world.robot.radius_m = 0.2;
  world.robot.speed_m_per_s = 0.5;
  world.robot.drive = {Go{3.0}};
  world.solids = {wall_at(2.2)};
  const auto collision = first_collision(world, 10.0);
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->first, "robot");
  EXPECT_EQ(collision->second, "wall");
  EXPECT_NEAR(collision->time_s, (2.2 - 0.2) / 0.5, kBetweenLooks_s);
  EXPECT_FALSE(first_collision(world, 3.9));
}

TEST(FirstCollisionTest, TwoOnOneWayMeetInItsMiddleUnlessTheyGiveWay) {
  World world;
  world.robot.X_WR.p_m = {0, -5};
  world.walkers = {walker("ann", {0, 0}, {8, 0}), walker("ben", {8, 0}, {0, 0})};
  const auto collision = first_collision(world, 10.0);
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->first, "ann");
  EXPECT_EQ(collision->second, "ben");
  // Legs are up to .42 of a step before the hips at the laser's height, and .06 m thick.
  const double speed_m_per_s = world.walkers[0].speed_m_per_s;
  EXPECT_NEAR(collision->time_s, 4.0 / speed_m_per_s, 0.5 * step_length_m(speed_m_per_s) / speed_m_per_s);
  for (Walker& each : world.walkers) each.avoids = true;
  EXPECT_FALSE(first_collision(world, 10.0));
}

TEST(FirstCollisionTest, WhatHangsAboveTheLaserStopsNobody) {
  World world;
  world.robot.X_WR.p_m = {0, -5};
  world.walkers = {walker("ann", {0, 0}, {8, 0})};
  world.solids = {wall_at(4.0)};
  EXPECT_TRUE(first_collision(world, 10.0));
  world.solids[0].bottom_m = world.robot.laser_height_m + 0.1;
  EXPECT_FALSE(first_collision(world, 10.0));
}

}  // namespace
}  // namespace scanbed::sim
