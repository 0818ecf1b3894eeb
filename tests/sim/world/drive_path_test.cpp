// SPDX-License-Identifier: MIT
#include "sim/world/drive_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>

#include "core/errors/input_error.hpp"
#include "tests/sim/world/expect_pose.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using testing::expect_pose;
using testing::kRounding;

// Some twenty products and sums of numbers of size 10.

Robot robot() {
  Robot r;
  r.speed_m_per_s = 0.5;
  r.turn_rad_per_s = 0.25;
  return r;
}

Pose2 end_of(const std::vector<Motion>& motions, Pose2 X_WR) {
  for (const Motion& motion : motions) X_WR = motion.pose_behind(X_WR, motion.duration_s);
  return X_WR;
}

double duration_s(const std::vector<Motion>& motions) {
  return std::accumulate(motions.begin(), motions.end(), 0.0,
                         [](double sum, const Motion& motion) { return sum + motion.duration_s; });
}

TEST(DrivePathTest, AnArcIsAPieceOfACircle) {
  const Motion arc{.duration_s = kPi, .speed_m_per_s = 2.0, .turn_rad_per_s = 0.5};
  const Pose2 X_WR{{1.0, 1.0}, 0.0};
  // Radius 4, centre (1, 5).
  expect_pose(arc.pose_behind(X_WR, kPi), {5.0, 5.0}, kPi / 2);
  for (const double t_s : {0.1, 0.7, 2.0, 3.0}) {
    EXPECT_NEAR((arc.pose_behind(X_WR, t_s).p_m - Vector2d(1.0, 5.0)).norm(), 4.0, kRounding);
  }
}

TEST(DrivePathTest, TurnsOnTheSpotThenGoesStraightToASinglePoint) {
  const std::vector<Motion> motions = motions_along({.points_m = {{1.0, 4.0}}}, {{1.0, 2.0}, 0.0}, robot());
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_DOUBLE_EQ(motions[0].duration_s, kPi / 2 / 0.25);
  EXPECT_DOUBLE_EQ(motions[1].duration_s, 2.0 / 0.5);
  expect_pose(end_of(motions, {{1.0, 2.0}, 0.0}), {1.0, 4.0}, kPi / 2);
}

TEST(DrivePathTest, RoundsACornerWithTheRadiusAskedFor) {
  const FollowPath path{.points_m = {{4.0, 0.0}, {4.0, -3.0}}, .round_m = 1.0};
  const std::vector<Motion> motions = motions_along(path, {}, robot());
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_DOUBLE_EQ(motions[0].duration_s, 3.0 / 0.5);
  // 1 m at 0.25 rad/s is 0.25 m/s.
  EXPECT_DOUBLE_EQ(motions[1].speed_m_per_s, 0.25);
  EXPECT_DOUBLE_EQ(motions[1].turn_rad_per_s, -0.25);
  EXPECT_DOUBLE_EQ(motions[1].duration_s, kPi / 2 / 0.25);
  EXPECT_DOUBLE_EQ(motions[2].duration_s, 2.0 / 0.5);
  const Pose2 before = motions[0].pose_behind({}, motions[0].duration_s);
  // Halfway round the arc is nearest to the corner: sqrt(2) - 1 radii from it.
  const Pose2 middle = motions[1].pose_behind(before, 0.5 * motions[1].duration_s);
  EXPECT_NEAR((middle.p_m - Vector2d(4.0, 0.0)).norm(), std::sqrt(2.0) - 1.0, kRounding);
  expect_pose(end_of(motions, {}), {4.0, -3.0}, -kPi / 2);
}

TEST(DrivePathTest, TheRadiusIsTheTightestThatFullSpeedTakesUnlessSaid) {
  const std::vector<Motion> motions = motions_along({.points_m = {{9.0, 0.0}, {9.0, 9.0}}}, {}, robot());
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_DOUBLE_EQ(motions[1].speed_m_per_s, 0.5);
  EXPECT_DOUBLE_EQ(motions[1].turn_rad_per_s, 0.25);  // 2 m
}

TEST(DrivePathTest, ACornerGetsNoMoreThanHalfOfEachEdge) {
  const std::vector<Motion> motions = motions_along({.points_m = {{1.0, 0.0}, {1.0, 9.0}}}, {}, robot());
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_DOUBLE_EQ(motions[0].duration_s, 0.5 / 0.5);
  EXPECT_NEAR(motions[1].speed_m_per_s / motions[1].turn_rad_per_s, 0.5, kRounding);
  EXPECT_DOUBLE_EQ(motions[1].turn_rad_per_s, 0.25);
}

TEST(DrivePathTest, TurnsOnTheSpotWhereThereIsNoArc) {
  const FollowPath back{.points_m = {{2.0, 0.0}, {0.0, 0.0}}};
  const std::vector<Motion> motions = motions_along(back, {}, robot());
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[1].speed_m_per_s, 0.0);
  EXPECT_DOUBLE_EQ(motions[1].duration_s, kPi / 0.25);
  const FollowPath sharp{.points_m = {{2.0, 0.0}, {2.0, 2.0}}, .round_m = 0.0};
  EXPECT_EQ(motions_along(sharp, {}, robot())[1].speed_m_per_s, 0.0);
}

TEST(DrivePathTest, GoesRoundASquareAsOftenAsAskedFor) {
  const FollowPath square{
      .points_m = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}, .rounds = 3, .round_m = 1.0};
  const std::vector<Motion> motions = motions_along(square, {}, robot());
  // 12 edges of 4 m; at each of the 11 corners between them 2 m less, and a quarter of a circle at 0.25 m/s.
  EXPECT_NEAR(duration_s(motions), (12 * 4.0 - 11 * 2.0) / 0.5 + 11 * (kPi / 2) / 0.25, 1e-9);
  expect_pose(end_of(motions, {}), {0.0, 0.0}, -kPi / 2);
}

TEST(DrivePathTest, WhereItStandsAlreadyItNeedNotGo) {
  EXPECT_TRUE(motions_along({.points_m = {{0.0, 0.0}}}, {}, robot()).empty());
}

RC_GTEST_PROP(DrivePathTest, EndsAtTheLastPointWithinItsSpeeds, ()) {
  FollowPath path;
  path.points_m = {{0.0, 0.0}};
  for (const int code : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4000))) {
    path.points_m.push_back(path.points_m.back() + Vector2d(code % 7 - 3.05, code / 7 % 9 - 4.02));
  }
  path.round_m = *rc::gen::inRange(0, 30) / 10.0;
  validate_path(path, "robot");
  const std::vector<Motion> motions = motions_along(path, {{-1.0, 0.5}, 1.0}, robot());
  for (const Motion& motion : motions) {
    RC_ASSERT(motion.duration_s >= 0.0);
    RC_ASSERT(std::abs(motion.speed_m_per_s) <= 0.5 + 1e-12);
    RC_ASSERT(std::abs(motion.turn_rad_per_s) <= 0.25 + 1e-12);
  }
  const Vector2d miss_m = end_of(motions, {{-1.0, 0.5}, 1.0}).p_m - path.points_m.back();
  RC_ASSERT(miss_m.norm() < 1e-9);
}

TEST(DrivePathTest, RefusesWhatCannotBeDriven) {
  const auto expect_refused = [](const FollowPath& path, const std::string& begin) {
    try {
      validate_path(path, "robot");
      FAIL() << begin;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, begin.size()), begin);
    }
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expect_refused({}, "robot: path: number of points: value 0");
  expect_refused({.points_m = {{kNan, 0.0}}}, "robot: path: point 0: value nan");
  expect_refused({.points_m = {{0.0, 0.0}, {2000.0, 0.0}}}, "robot: path: point 1: value 2000");
  expect_refused({.points_m = {{1.0, 0.0}, {1.0, 0.0}}},
                 "robot: path: point 1: distance from the point before");
  expect_refused({.points_m = {{1.0, 0.0}}, .rounds = 1}, "robot: path: number of points: value 1");
  expect_refused({.points_m = {{1.0, 0.0}, {2.0, 0.0}}, .rounds = 60'000},
                 "robot: path: rounds: value 60000");
  expect_refused({.points_m = {{1.0, 0.0}}, .round_m = -0.1}, "robot: path: round_m: value -0.1");
}

}  // namespace
}  // namespace scanbed::sim
