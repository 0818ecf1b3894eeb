// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angles.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

TEST(LoadRobotTest, TakesEveryKey) {
  const sim::Robot robot = parse(
                               "robot: {use: pioneer2dx, pose: [1, 2, 90], laser: [0.1, 0, -90], speed: 0.4, "
                               "radius: 0.3, turn_rate_deg: 45}\n")
                               .world.robot;
  EXPECT_EQ(robot.X_WR.p_m, Eigen::Vector2d(1.0, 2.0));
  EXPECT_DOUBLE_EQ(robot.X_WR.theta_rad, kPi / 2);
  EXPECT_EQ(robot.X_RS.p_m, Eigen::Vector2d(0.1, 0.0));
  EXPECT_DOUBLE_EQ(robot.X_RS.theta_rad, -kPi / 2);
  EXPECT_DOUBLE_EQ(robot.speed_m_per_s, 0.4);
  EXPECT_DOUBLE_EQ(robot.radius_m, 0.3);
  EXPECT_DOUBLE_EQ(robot.turn_rad_per_s, kPi / 4);
}

TEST(LoadRobotTest, KeepsTheDrivePlansOrder) {
  const sim::Robot robot = parse("robot: {drive: [{wait: 2}, {turn_deg: -180}, {go: 3}]}\n").world.robot;
  ASSERT_EQ(robot.drive.size(), 3u);
  EXPECT_DOUBLE_EQ(std::get<sim::Wait>(robot.drive[0]).duration_s, 2.0);
  EXPECT_DOUBLE_EQ(std::get<sim::Turn>(robot.drive[1]).angle_rad, -kPi);
  EXPECT_DOUBLE_EQ(std::get<sim::Go>(robot.drive[2]).distance_m, 3.0);
}

TEST(LoadRobotTest, TakesPathsAndWhomToFollow) {
  const sim::Robot robot = parse(
                               "robot: {drive: [{path: {line: [[1, 2]]}}, "
                               "{path: {loop: [[0, 0], [3, 0]], rounds: 4, round: 0.5}}, {follow: {}}, "
                               "{follow: {distance: 1.5, for: 20, within: 3, patience: 2}}]}\n")
                               .world.robot;
  const auto& line = std::get<sim::FollowPath>(robot.drive[0]);
  EXPECT_EQ(line.points_m, (std::vector<Eigen::Vector2d>{{1, 2}}));
  EXPECT_EQ(line.rounds, 0);
  EXPECT_FALSE(line.round_m);
  const auto& loop = std::get<sim::FollowPath>(robot.drive[1]);
  EXPECT_EQ(loop.rounds, 4);
  EXPECT_EQ(loop.round_m, 0.5);
  EXPECT_TRUE(std::isinf(std::get<sim::FollowLegs>(robot.drive[2]).for_s));
  const auto& follow = std::get<sim::FollowLegs>(robot.drive[3]);
  EXPECT_EQ(follow.distance_m, 1.5);
  EXPECT_EQ(follow.for_s, 20.0);
  EXPECT_EQ(follow.within_m, 3.0);
  EXPECT_EQ(follow.patience_s, 2.0);
}

TEST(LoadRobotTest, RefusesPathsThatAreNotOneThing) {
  EXPECT_EQ(parse_error("robot: {drive: [{path: {}}]}\n"),
            "f:4:24: path: a path is exactly one of loop and line");
  EXPECT_EQ(parse_error("robot: {drive: [{path: {line: [[1, 2]], rounds: 2}}]}\n"),
            "f:4:49: rounds: a line is driven once; it goes with loop");
  EXPECT_EQ(parse_error("robot: {drive: [{path: {loop: [[1, 2]]}}]}\n"),
            "f:4:31: loop: expected at least 2 points, found 1");
  EXPECT_EQ(parse_error("robot: {drive: [{follow: {for: 0}}]}\n"),
            "f:4:32: for: value 0 is out of range; allowed: (0, 86400]");
}

TEST(LoadRobotTest, RefusesStepsThatAreNotOneThing) {
  EXPECT_EQ(parse_error("robot: {drive: [{wait: 1, go: 2}]}\n"),
            "f:4:17: drive: a step is exactly one of wait, turn_deg, go, path and follow");
  EXPECT_EQ(parse_error("robot: {drive: [{}]}\n"),
            "f:4:17: drive: a step is exactly one of wait, turn_deg, go, path and follow");
  EXPECT_EQ(parse_error("robot: {drive: [{turn: 90}]}\n"),
            "f:4:18: unknown key 'turn'; known keys: wait, turn_deg, go, path, follow");
  EXPECT_EQ(parse_error("robot: {drive: [{wait: -1}]}\n"),
            "f:4:24: wait: value -1 is out of range; allowed: [0, 86400]");
}

TEST(LoadRobotTest, RefusesWhatNoRobotCan) {
  EXPECT_EQ(parse_error("robot: {speed: 0}\n"), "f:4:16: speed: value 0 is out of range; allowed: (0, 5]");
  EXPECT_EQ(parse_error("robot: {pose: [0, 0]}\n"), "f:4:15: pose: expected 3 values, found 2");
  EXPECT_EQ(parse_error("robot: {posse: [0, 0, 0]}\n"), "f:4:9: unknown key 'posse'; did you mean 'pose'?");
}

}  // namespace
}  // namespace scanbed::scenarios
