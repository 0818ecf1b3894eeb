// SPDX-License-Identifier: MIT
#include "sim/world/leg_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kPeriod_s = 0.2;

Robot quick_robot() {
  Robot r;
  r.speed_m_per_s = 1.5;
  r.turn_rad_per_s = 1.0;
  return r;
}

std::vector<Leg> pair_at(const Vector2d& p_m) {
  return {{.middle_m = p_m - Vector2d(0.0, 0.1)}, {.middle_m = p_m + Vector2d(0.0, 0.1)}};
}

TEST(LegFollowerTest, StandsStillWhileThereIsNobody) {
  LegFollower follower(quick_robot(), {});
  for (const std::vector<Leg>& legs :
       {std::vector<Leg>{}, std::vector<Leg>{{.middle_m = {2.0, 0.0}}},
        std::vector<Leg>{{.middle_m = {2.0, 0.0}}, {.middle_m = {2.0, 0.9}}}, pair_at({4.5, 0.0})}) {
    const DriveCommand command = follower.update({0.0, {}, legs, kPeriod_s});
    EXPECT_EQ(command.speed_m_per_s, 0.0);
    EXPECT_EQ(command.turn_rad_per_s, 0.0);
    EXPECT_FALSE(follower.person_m());
  }
}

TEST(LegFollowerTest, TakesUpTheNearestPair) {
  LegFollower follower(quick_robot(), {});
  std::vector<Leg> legs = pair_at({3.0, 1.0});
  for (const Leg& leg : pair_at({2.0, -1.0})) legs.push_back(leg);
  follower.update({0.0, {}, legs, kPeriod_s});
  EXPECT_NEAR((*follower.person_m() - Vector2d(2.0, -1.0)).norm(), 0.0, 1e-12);
}

TEST(LegFollowerTest, ComesNearerTurnsAndKeepsItsDistance) {
  LegFollower follower(quick_robot(), {.distance_m = 1.0});
  // Half a metre too far, straight ahead.
  DriveCommand command = follower.update({0.0, {}, pair_at({1.5, 0.0}), kPeriod_s});
  EXPECT_NEAR(command.speed_m_per_s, 0.5, 1e-12);
  EXPECT_NEAR(command.turn_rad_per_s, 0.0, 1e-12);
  // To the left, as fast as it can; what lies behind is not driven to before it is ahead.
  LegFollower turning(quick_robot(), {.distance_m = 1.0});
  command = turning.update({0.0, {}, pair_at({-2.0, 0.5}), kPeriod_s});
  EXPECT_EQ(command.speed_m_per_s, 0.0);
  EXPECT_EQ(command.turn_rad_per_s, 1.0);
  // Too near: it stands, and does not back away.
  LegFollower near(quick_robot(), {.distance_m = 1.0});
  EXPECT_EQ(near.update({0.0, {}, pair_at({0.6, 0.0}), kPeriod_s}).speed_m_per_s, 0.0);
}

TEST(LegFollowerTest, TakesItsLaserForWhereItIs) {
  Robot carrying = quick_robot();
  carrying.X_RS = {{0.2, 0.0}, kPi / 2};  // looks to the left
  LegFollower follower(carrying, {.distance_m = 1.0});
  const DriveCommand command = follower.update({0.0, {}, pair_at({0.0, -1.5}), kPeriod_s});
  EXPECT_NEAR((*follower.person_m() - Vector2d(1.7, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(command.speed_m_per_s, 0.5, 1e-12);
}

// Drives itself after a point that moves as told, as the simulation does; returns the distances.
std::vector<double> chase(const Vector2d& v_m_per_s, double for_s, double period_s = kPeriod_s) {
  LegFollower follower(quick_robot(), {.distance_m = 1.2});
  Pose2 X_WR;
  DriveCommand in_force;
  std::vector<double> distances_m;
  for (double t_s = 0.0; t_s < for_s; t_s += period_s) {
    const Vector2d p_RQ = X_WR.inverse() * (Vector2d(2.0, 0.0) + t_s * v_m_per_s);
    distances_m.push_back(p_RQ.norm());
    const std::vector<Leg> legs = pair_at(p_RQ);
    const DriveCommand next = follower.update({t_s, X_WR, legs, period_s});
    X_WR = Motion{period_s, in_force.speed_m_per_s, in_force.turn_rad_per_s}.pose_behind(X_WR, period_s);
    in_force = next;
  }
  return distances_m;
}

// The speed is fed forward, so there is no lag left where it is constant.
TEST(LegFollowerTest, BehindWhoWalksStraightTheDistanceSettles) {
  for (const Vector2d& v_m_per_s : {Vector2d(1.0, 0.0), Vector2d(0.5, 0.5), Vector2d(0.0, -0.6)}) {
    for (const double period_s : {0.2, 1.0 / 37.5}) {
      const std::vector<double> distances_m = chase(v_m_per_s, 30.0, period_s);
      EXPECT_NEAR(distances_m.back(), 1.2, 0.02) << v_m_per_s.transpose() << ", every " << period_s << " s";
    }
  }
}

TEST(LegFollowerTest, SlowScansMakeItSlowNotWild) {
  const std::vector<double> distances_m = chase({0.0, 0.0}, 200.0, 2.0);
  EXPECT_NEAR(distances_m.back(), 1.2, 0.02);
  EXPECT_GT(*std::min_element(distances_m.begin(), distances_m.end()), 1.1);
}

TEST(LegFollowerTest, GoesOnWithOneLegAndForAWhileWithout) {
  LegFollower follower(quick_robot(), {.distance_m = 1.0, .patience_s = 1.1});
  double t_s = 0.0;
  const auto see = [&](const std::vector<Leg>& legs) {
    t_s += kPeriod_s;
    return follower.update({t_s, {}, legs, kPeriod_s}).speed_m_per_s;
  };
  EXPECT_GT(see(pair_at({2.0, 0.0})), 0.0);
  for (int k = 0; k < 20; ++k) EXPECT_GT(see({{.middle_m = {2.0, 0.1}}}), 0.0);
  for (int k = 0; k < 5; ++k) EXPECT_GT(see({}), 0.0) << k;
  // Lost; a single leg is nobody then.
  EXPECT_EQ(see({}), 0.0);
  EXPECT_EQ(see({{.middle_m = {2.0, 0.1}}}), 0.0);
  EXPECT_GT(see(pair_at({3.0, 0.0})), 0.0);
}

TEST(LegFollowerTest, KeepsToItsPersonWhenAnotherComesNearer) {
  LegFollower follower(quick_robot(), {});
  follower.update({0.0, {}, pair_at({2.0, 0.0}), kPeriod_s});
  std::vector<Leg> legs = pair_at({2.0, 0.0});
  for (const Leg& leg : pair_at({1.0, 0.3})) legs.push_back(leg);
  for (int k = 1; k < 10; ++k) follower.update({k * kPeriod_s, {}, legs, kPeriod_s});
  EXPECT_NEAR((*follower.person_m() - Vector2d(2.0, 0.0)).norm(), 0.0, 0.01);
}

}  // namespace
}  // namespace scanbed::sim
