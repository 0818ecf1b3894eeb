// SPDX-License-Identifier: MIT
#include "sim/world/crowd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kLaserHeight_m = 0.28;

Walker walker(const std::string& id, const Vector2d& from, const Vector2d& to, bool avoids) {
  Walker walker;
  walker.id = id;
  walker.path.points_m = {from, to};
  walker.avoids = avoids;
  return walker;
}

double least_distance_m(const World& world) {
  const Crowd crowd(world, kLaserHeight_m);
  std::vector<WalkerState> states;
  double least_m = 1e9;
  for (double t = 0.0; t < 12.0; t += 0.01) {
    crowd.states_at(t, states);
    for (std::size_t i = 0; i < states.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        least_m = std::min(least_m, (states[i].X_WP.p_m - states[j].X_WP.p_m).norm());
    }
  }
  return least_m;
}

TEST(CrowdTest, WithoutGivingWayWalkersFollowTheirScripts) {
  World world;
  world.walkers = {walker("a", {0, 0}, {8, 0}, false), walker("b", {8, 0}, {0, 0}, false)};
  EXPECT_LT(least_distance_m(world), 0.05);
}

TEST(CrowdTest, WalkersHeadOnPassEachOtherOnTheRight) {
  World world;
  world.walkers = {walker("a", {0, 0}, {8, 0}, true), walker("b", {8, 0}, {0, 0}, true)};
  EXPECT_GT(least_distance_m(world), 0.5);  // shoulders are narrower
  const Crowd crowd(world, kLaserHeight_m);
  std::vector<WalkerState> states;
  crowd.states_at(4.0 / 1.37, states);  // where they meet
  EXPECT_LT(states[0].X_WP.p_m.y(), -0.25);
  EXPECT_GT(states[1].X_WP.p_m.y(), 0.25);
  crowd.states_at(0.0, states);
  EXPECT_EQ(states[0].X_WP.p_m, Vector2d(0, 0));
}

TEST(CrowdTest, CrossingWalkersKeepFartherApart) {
  World world;
  world.walkers = {walker("a", {0, 0}, {8, 0}, false), walker("b", {4.3, -4}, {4.3, 4}, false)};
  const double unaware_m = least_distance_m(world);
  for (Walker& w : world.walkers) w.avoids = true;
  EXPECT_GT(least_distance_m(world), unaware_m + 0.1);
}

TEST(CrowdTest, APairKeepsItsDistance) {
  World world;
  world.walkers = {walker("a", {0, 0}, {8, 0}, true), walker("b", {0, 0}, {8, 0}, true)};
  world.walkers[0].lateral_m = 0.3;
  world.walkers[1].lateral_m = -0.3;
  const Crowd crowd(world, kLaserHeight_m);
  std::vector<WalkerState> states;
  for (double t = 0.0; t < 8.0; t += 0.1) {
    crowd.states_at(t, states);
    EXPECT_NEAR((states[0].X_WP.p_m - states[1].X_WP.p_m).norm(), 0.6, 1e-9);
    EXPECT_NEAR(states[0].X_WP.p_m.y(), 0.3, 1e-9);
  }
}

// A standing foot stays where it is, whoever comes; and nothing jumps.
TEST(CrowdTest, FeetStandStillAndLegsNeverJumpWhileAWalkerStepsAside) {
  World world;
  world.walkers = {walker("a", {0, 0}, {8, 0}, true), walker("b", {8, 0}, {0, 0}, true),
                   walker("c", {3, 3}, {5, -3}, true)};
  world.walkers[1].stops = {{.at_m = 2.0, .for_s = 3.0, .turn_rad = 1.0}};
  const Crowd crowd(world, kLaserHeight_m);
  std::vector<WalkerState> before, states;
  crowd.states_at(0.0, before);
  constexpr double kStep_s = 1e-3;
  int num_standing = 0;
  for (int k = 1; k < 9000; ++k) {
    crowd.states_at(k * kStep_s, states);
    for (int i = 0; i < 3; ++i) {
      // Fastest: the swinging foot, 1.44 m plus both side steps in 0.42 s.
      ASSERT_LE((states[i].left_leg_m - before[i].left_leg_m).norm(), 6.0 * kStep_s) << i << " at " << k;
      ASSERT_LE((states[i].right_leg_m - before[i].right_leg_m).norm(), 6.0 * kStep_s) << i << " at " << k;
    }
    num_standing += states[0].left_foot_m == before[0].left_foot_m;
    before = states;
  }
  EXPECT_GT(num_standing, 0.55 * 5800);  // 60 % of the 5.84 s for which it walks
}

}  // namespace
}  // namespace scanbed::sim
