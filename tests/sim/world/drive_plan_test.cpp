// SPDX-License-Identifier: MIT
#include "sim/world/drive_plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/sim/world/expect_pose.hpp"

namespace scanbed::sim {
namespace {

using testing::expect_pose;
using testing::kRounding;

// Poses are sums and products of a few doubles of size 1 to 10.

Robot robot(std::vector<DriveStep> drive) {
  Robot r;
  r.X_WR = {{1.0, 2.0}, kPi / 2};
  r.speed_m_per_s = 0.5;
  r.turn_rad_per_s = 0.25;
  r.drive = std::move(drive);
  return r;
}

TEST(DrivePlanTest, WithoutStepsStandsStill) {
  const DrivePlan plan(robot({}));
  EXPECT_EQ(plan.end_s(), 0.0);
  expect_pose(plan.pose_at(-1.0), {1.0, 2.0}, kPi / 2);
  expect_pose(plan.pose_at(100.0), {1.0, 2.0}, kPi / 2);
}

TEST(DrivePlanTest, GoesAheadAndBackwardsAtItsSpeed) {
  const DrivePlan plan(robot({Go{1.0}, Go{-0.5}}));
  expect_pose(plan.pose_at(1.0), {1.0, 2.5}, kPi / 2);
  expect_pose(plan.pose_at(2.0), {1.0, 3.0}, kPi / 2);
  expect_pose(plan.pose_at(2.5), {1.0, 2.75}, kPi / 2);
  expect_pose(plan.pose_at(3.0), {1.0, 2.5}, kPi / 2);
  EXPECT_DOUBLE_EQ(plan.end_s(), 3.0);
}

TEST(DrivePlanTest, WaitsTurnsThenGoesTheNewWay) {
  const DrivePlan plan(robot({Wait{2.0}, Turn{-kPi / 2}, Go{3.0}}));
  expect_pose(plan.pose_at(2.0), {1.0, 2.0}, kPi / 2);
  expect_pose(plan.pose_at(3.0), {1.0, 2.0}, kPi / 2 - 0.25);
  const double turned_s = 2.0 + kPi / 2 / 0.25;
  expect_pose(plan.pose_at(turned_s), {1.0, 2.0}, 0.0);
  expect_pose(plan.pose_at(turned_s + 6.0), {4.0, 2.0}, 0.0);
  expect_pose(plan.pose_at(1e6), {4.0, 2.0}, 0.0);
}

TEST(DrivePlanTest, MoreThanAFullTurnTakesItsTime) {
  const DrivePlan plan(robot({Turn{3.0 * kPi}}));
  EXPECT_DOUBLE_EQ(plan.end_s(), 12.0 * kPi);
  expect_pose(plan.pose_at(8.0 * kPi), {1.0, 2.0}, kPi / 2);
  expect_pose(plan.pose_at(12.0 * kPi), {1.0, 2.0}, -kPi / 2);
}

TEST(DrivePlanTest, StepsThatTakeNoTimeChangeNothing) {
  const DrivePlan plan(robot({Wait{0.0}, Turn{0.0}, Go{0.0}}));
  EXPECT_EQ(plan.end_s(), 0.0);
  expect_pose(plan.pose_at(0.0), {1.0, 2.0}, kPi / 2);
}

TEST(DrivePlanTest, DrivesAlongAPathFromWhereItStands) {
  const DrivePlan plan(
      robot({Go{1.0}, FollowPath{.points_m = {{1.0, 6.0}, {3.0, 6.0}}, .round_m = 1.0}, Go{1.0}}));
  // From (1, 3): 2 m ahead, a quarter of a circle of 1 m at 0.25 m/s, 1 m on to (3, 6).
  const double arc_s = 2.0 + 4.0;
  expect_pose(plan.pose_at(arc_s), {1.0, 5.0}, kPi / 2);
  const double behind_s = arc_s + kPi / 2 / 0.25;
  expect_pose(plan.pose_at(behind_s), {2.0, 6.0}, 0.0);
  expect_pose(plan.pose_at(behind_s + 2.0), {3.0, 6.0}, 0.0);
  expect_pose(plan.pose_at(1e6), {4.0, 6.0}, 0.0);
}

TEST(DrivePlanTest, StandsStillWhileItFollowsWithoutACommand) {
  const DrivePlan plan(robot({FollowLegs{.for_s = 5.0}, Go{1.0}}));
  expect_pose(plan.pose_at(5.0), {1.0, 2.0}, kPi / 2);
  expect_pose(plan.pose_at(7.0), {1.0, 3.0}, kPi / 2);
  EXPECT_EQ(plan.following_at(4.9)->for_s, 5.0);
  EXPECT_EQ(plan.following_at(5.0), nullptr);
  EXPECT_TRUE(std::isinf(DrivePlan(robot({FollowLegs{}, Go{1.0}})).end_s()));
}

TEST(DrivePlanTest, DoesAsCommandedUntilTheNextCommandOrTheStepsEnd) {
  DrivePlan plan(robot({Wait{1.0}, FollowLegs{.for_s = 4.0}, Go{1.0}}));
  plan.command(0.5, {.speed_m_per_s = 0.5});  // too early
  plan.command(2.0, {.speed_m_per_s = 0.5});
  expect_pose(plan.pose_at(2.0), {1.0, 2.0}, kPi / 2);
  expect_pose(plan.pose_at(3.0), {1.0, 2.5}, kPi / 2);
  plan.command(3.0, {.speed_m_per_s = 0.0, .turn_rad_per_s = -0.25});
  expect_pose(plan.pose_at(2.5), {1.0, 2.25}, kPi / 2);
  expect_pose(plan.pose_at(5.0), {1.0, 2.5}, kPi / 2 - 0.5);
  plan.command(5.0, {.speed_m_per_s = 0.5});  // too late
  expect_pose(plan.pose_at(7.0), Eigen::Vector2d(1.0, 2.5) + Pose2{{}, kPi / 2 - 0.5}.heading(),
              kPi / 2 - 0.5);
}

TEST(DrivePlanTest, PlansTheRestFromWhereFollowingEnds) {
  DrivePlan plan(robot({FollowLegs{.for_s = 4.0}, FollowPath{.points_m = {{1.0, 9.0}}}}));
  for (int k = 0; k < 8; ++k) plan.command(0.5 * k, {.speed_m_per_s = k % 2 == 0 ? 0.5 : 0.0});
  expect_pose(plan.pose_at(4.0), {1.0, 3.0}, kPi / 2);
  EXPECT_DOUBLE_EQ(plan.end_s(), 4.0 + 6.0 / 0.5);
}

RC_GTEST_PROP(DrivePlanTest, NeverMovesFasterThanItsSpeeds, ()) {
  std::vector<DriveStep> drive;
  for (const int code : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-300, 300))) {
    const double amount = code / 50.0;
    if (code % 3 == 0) drive.push_back(Go{amount});
    if (code % 3 == 1) drive.push_back(Turn{amount});
    if (code % 3 == 2) drive.push_back(FollowPath{.points_m = {{amount, 1.0}, {2.0, amount}}});
  }
  const DrivePlan plan(robot(drive));
  constexpr double kStep_s = 0.1;
  for (double t_s = 0.0; t_s < plan.end_s() + 1.0; t_s += kStep_s) {
    const Pose2 a = plan.pose_at(t_s);
    const Pose2 b = plan.pose_at(t_s + kStep_s);
    RC_ASSERT((b.p_m - a.p_m).norm() <= 0.5 * kStep_s + 1e-9);
    RC_ASSERT(std::abs(wrap_to_pi(b.theta_rad - a.theta_rad)) <= 0.25 * kStep_s + 1e-9);
  }
}

}  // namespace
}  // namespace scanbed::sim
