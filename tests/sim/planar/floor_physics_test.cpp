// SPDX-License-Identifier: MIT
#include "sim/planar/floor_physics.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 1.0 / 300;
constexpr double kSlop_m = 0.005;  // b2_linearSlop: what Box2D leaves uncorrected
constexpr Vector2d (*kNowhere)(double) = [](double) { return Vector2d(50, 50); };

/// A world with one walker, who tows; the test moves pelvis and legs as it likes.
World world_with_tow() {
  World world;
  Walker walker;
  walker.id = "anna";
  walker.path.points_m = {{0, 0}, {1, 0}};
  walker.tow = Tow{};
  walker.tow->id = "cyl";
  world.walkers.push_back(walker);
  world.robot.X_WR = {{-50, -50}, 0.0};
  return world;
}

constexpr double kTaut_m = 0.9 + 0.25;

struct Script {
  Vector2d (*pelvis)(double);
  Vector2d (*leg)(double) = kNowhere;
};

WorldState state_at(const Script& script, double time_s) {
  WorldState state;
  state.time_s = time_s;
  state.X_WR = {{-50, -50}, 0.0};
  state.walkers.resize(1);
  state.walkers[0].present = true;
  state.walkers[0].X_WP = {script.pelvis(time_s), 0.0};
  state.walkers[0].left_leg_m = script.leg(time_s);
  state.walkers[0].right_leg_m = kNowhere(0);
  return state;
}

/// Where the cylinder is after each step.
std::vector<Vector2d> way_of_cylinder(const World& world, const Script& script, double until_s) {
  FloorPhysics physics(world, state_at(script, 0.0));
  std::vector<Vector2d> way;
  const int num_steps = static_cast<int>(std::lround(until_s / kStep_s));
  for (int k = 0; k <= num_steps; ++k) {
    WorldState next = state_at(script, k * kStep_s);
    physics.step_to(next);
    way.push_back(next.tows.at(0).center_m);
  }
  return way;
}

Vector2d at_origin(double) {
  return {0, 0};
}

Vector2d walk_along_x(double t_s) {
  return {1.2 * t_s, 0};
}

Vector2d walk_two_metres_then_stop(double t_s) {
  return {std::min(1.2 * t_s, 2.4), 0};
}

Vector2d walk_a_circle(double t_s) {
  return {1.5 * std::sin(0.8 * t_s), 1.5 - 1.5 * std::cos(0.8 * t_s)};
}

TEST(FloorPhysicsTest, TheCylinderStartsATautRopeBehindAndStaysThereAtRest) {
  const std::vector<Vector2d> way = way_of_cylinder(world_with_tow(), {at_origin}, 2.0);
  EXPECT_NEAR((way.front() - Vector2d(-kTaut_m, 0)).norm(), 0.0, 1e-6);  // one rounding to float
  EXPECT_NEAR((way.back() - Vector2d(-kTaut_m, 0)).norm(), 0.0, kSlop_m);
}

TEST(FloorPhysicsTest, AStraightPullKeepsItATautRopeBehind) {
  const std::vector<Vector2d> way = way_of_cylinder(world_with_tow(), {walk_along_x}, 5.0);
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Vector2d expected = walk_along_x(static_cast<double>(k) * kStep_s) - Vector2d(kTaut_m, 0);
    ASSERT_NEAR((way[k] - expected).norm(), 0.0, 1.2 * kStep_s + kSlop_m) << k;
  }
}

// On its own it slides v^2 / (2 mu g); the legs are out of its way.
TEST(FloorPhysicsTest, WhenTheWalkerStopsFrictionStopsTheCylinder) {
  const double slide_m = 1.2 * 1.2 / (2 * 0.3 * 9.81);
  const std::vector<Vector2d> way = way_of_cylinder(world_with_tow(), {walk_two_metres_then_stop}, 6.0);
  // Time steps decide when it starts and stops to slide: one step's way at each end.
  EXPECT_NEAR(way.back().x(), 2.4 - kTaut_m + slide_m, 2 * 1.2 * kStep_s + kSlop_m);
  EXPECT_NEAR(way.back().y(), 0.0, 1e-4);
  EXPECT_EQ(way.back(), way[way.size() - 300]) << "moves on though nothing pulls";
}

TEST(FloorPhysicsTest, OnACircleTheCylinderFollowsWithinItsRope) {
  const std::vector<Vector2d> way = way_of_cylinder(world_with_tow(), {walk_a_circle}, 40.0);
  for (std::size_t k = 0; k < way.size(); ++k) {
    const double distance_m = (way[k] - walk_a_circle(static_cast<double>(k) * kStep_s)).norm();
    ASSERT_LE(distance_m, kTaut_m + kSlop_m + 1.2 * kStep_s) << k;
  }
  // In the end it goes round on a circle of radius rho, friction mu g along its way and w^2 rho inward, both
  // from the rope: its inward part is taut * q / sqrt(1 + q^2) with q = w^2 rho / (mu g), and the pelvis is
  // at R^2 = rho^2 - 2 rho inward + taut^2.
  const double rho_m = (way.back() - Vector2d(0, 1.5)).norm();
  const double q = 0.8 * 0.8 * rho_m / (0.3 * 9.81);
  const double inward_m = kTaut_m * q / std::sqrt(1 + q * q);
  const double pelvis_m = std::sqrt(rho_m * rho_m - 2 * rho_m * inward_m + kTaut_m * kTaut_m);
  EXPECT_NEAR(pelvis_m, 1.5, kSlop_m + 1.2 * kStep_s);
}

TEST(FloorPhysicsTest, ALegPushesTheCylinderAhead) {
  // The leg comes from behind at 0.5 m/s, from 1 m away; the pelvis stands beside.
  const Script script{at_origin, [](double t_s) { return Vector2d(-kTaut_m - 1.0 + 0.5 * t_s, 0.0); }};
  const std::vector<Vector2d> way = way_of_cylinder(world_with_tow(), script, 3.0);
  const double leg_x = script.leg(3.0).x();
  EXPECT_GE(way.back().x(), leg_x + 0.25 + 0.06 - 2 * kSlop_m - 0.5 * kStep_s);
  EXPECT_GT(way.back().x(), -kTaut_m + 0.5);
}

TEST(FloorPhysicsTest, WallsAndColumnsStopTheCylinder) {
  World world = world_with_tow();
  // The straight way of the cylinder is blocked at its edge by a column; the rope pulls it past.
  world.solids.push_back({"column", "column", Cylinder{{1.0, -0.3}, 0.2}, 0, 2.5, {}});
  world.solids.push_back({"wall", "wall", WallChain{{{-9, 0.4}, {9, 0.4}}, false}, 0, 2.5, {}});
  const std::vector<Vector2d> way = way_of_cylinder(world, {walk_along_x}, 4.0);
  double least_m = 1.0;
  for (const Vector2d& center : way) {
    for (const Solid& solid : world.solids)
      least_m = std::min(least_m, clearance_m(solid.shape, center) - 0.25);
  }
  EXPECT_GE(least_m, -2 * kSlop_m);
  EXPECT_LE(least_m, kSlop_m) << "it never touched anything";
  EXPECT_NEAR(way.back().x(), 4.8 - kTaut_m, 0.1) << "it did not get past";
}

TEST(FloorPhysicsTest, WhatHangsAboveTheCylinderDoesNotStopIt) {
  World world = world_with_tow();
  world.solids.push_back({"beam", "beam", Box{{{1, 0}, 0}, {0.1, 5}}, 1.5, 1.6, {}});
  const std::vector<Vector2d> way = way_of_cylinder(world, {walk_along_x}, 3.0);
  EXPECT_NEAR(way.back().x(), 3.6 - kTaut_m, kSlop_m + 1.2 * kStep_s);
}

TEST(FloorPhysicsTest, TheCylinderComesAndGoesWithItsWalker) {
  const World world = world_with_tow();
  WorldState state = state_at({at_origin}, 0.0);
  state.walkers[0].present = false;
  FloorPhysics physics(world, state);
  physics.step_to(state);
  EXPECT_FALSE(state.tows.at(0).present);
  WorldState come = state_at({at_origin}, kStep_s);
  come.walkers[0].X_WP = {{3, 4}, kPi / 2};
  physics.step_to(come);
  EXPECT_TRUE(come.tows.at(0).present);
  EXPECT_NEAR((come.tows[0].center_m - Vector2d(3, 4 - kTaut_m)).norm(), 0.0, kSlop_m);
  WorldState gone = state_at({at_origin}, 2 * kStep_s);
  gone.walkers[0].present = false;
  physics.step_to(gone);
  EXPECT_FALSE(gone.tows.at(0).present);
}

}  // namespace
}  // namespace scanbed::sim
