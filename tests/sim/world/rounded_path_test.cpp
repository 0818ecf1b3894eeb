// SPDX-License-Identifier: MIT
#include "sim/world/rounded_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kPathRounding = 1e-9;

void expect_on_path(const Pose2& pose, const Vector2d& p_m, double theta_rad) {
  EXPECT_NEAR((pose.p_m - p_m).norm(), 0.0, kPathRounding) << pose.p_m.transpose();
  EXPECT_NEAR(wrap_to_pi(pose.theta_rad - theta_rad), 0.0, kPathRounding) << pose.theta_rad;
}

Path square(double round_m) {
  return {.points_m = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, .loop = true, .round_m = round_m, .leave = false};
}

TEST(RoundedPathTest, AStraightPathIsWalkedFromEndToEnd) {
  const RoundedPath path({.points_m = {{1, 1}, {1, 3}}, .loop = false, .round_m = 0.0, .leave = false});
  EXPECT_DOUBLE_EQ(path.length_m(), 2.0);
  expect_on_path(path.pose_at(0.5), {1, 1.5}, kPi / 2);
  expect_on_path(path.pose_at(-1.0), {1, 1}, kPi / 2);
  expect_on_path(path.pose_at(9.0), {1, 3}, kPi / 2);
}

TEST(RoundedPathTest, RoundingReplacesCornersByQuarterCircles) {
  const RoundedPath path(square(0.5));
  EXPECT_NEAR(path.length_m(), 4 * 3.0 + 2 * kPi * 0.5, kPathRounding);
  expect_on_path(path.pose_at(0.0), {0.5, 0.0}, 0.0);
  expect_on_path(path.pose_at(3.0), {3.5, 0.0}, 0.0);
  const double eighth_m = 0.5 * kPi / 4;
  expect_on_path(path.pose_at(3.0 + eighth_m), Vector2d(3.5, 0.5) + 0.5 * Vector2d(1, -1).normalized(),
                 kPi / 4);
  expect_on_path(path.pose_at(3.0 + 2 * eighth_m), {4.0, 0.5}, kPi / 2);
  expect_on_path(path.pose_at(path.length_m() - eighth_m),
                 Vector2d(0.5, 0.5) - 0.5 * Vector2d(1, 1).normalized(), -kPi / 4);
}

TEST(RoundedPathTest, AnOpenPathTurnsRightToo) {
  const RoundedPath path(
      {.points_m = {{0, 0}, {2, 0}, {2, -2}}, .loop = false, .round_m = 1.0, .leave = false});
  EXPECT_NEAR(path.length_m(), 2.0 + kPi / 2, kPathRounding);
  expect_on_path(path.pose_at(1.0 + kPi / 4), Vector2d(1, -1) + Vector2d(1, 1).normalized(), -kPi / 4);
  expect_on_path(path.pose_at(99.0), {2, -2}, -kPi / 2);
}

TEST(RoundedPathTest, ALoopGoesRoundAndRound) {
  for (const double round_m : {0.0, 0.5, 2.0}) {
    const RoundedPath path(square(round_m));
    for (const double s_m : {0.3, 5.0, 11.0}) {
      const Pose2 pose = path.pose_at(s_m);
      expect_on_path(path.pose_at(s_m + 3 * path.length_m()), pose.p_m, pose.theta_rad);
      expect_on_path(path.pose_at(s_m - 2 * path.length_m()), pose.p_m, pose.theta_rad);
    }
  }
}

TEST(RoundedPathTest, ASharpCornerIsMetExactlyAndHalfTurnedThere) {
  const RoundedPath path(square(0.0));
  EXPECT_DOUBLE_EQ(path.length_m(), 16.0);
  expect_on_path(path.pose_at(4.0), {4, 0}, kPi / 4);
  expect_on_path(path.pose_at(4.0 - 0.075), {4 - 0.075, 0}, kPi / 8);
  expect_on_path(path.pose_at(4.0 + 0.15), {4, 0.15}, kPi / 2);
  expect_on_path(path.pose_at(2.0), {2, 0}, 0.0);
  expect_on_path(path.pose_at(0.0), {0, 0}, 0.0);
  expect_on_path(path.pose_at(16.0), {0, 0}, -kPi / 4);
}

TEST(RoundedPathTest, ToAndFroTurnsBackAtTheEnds) {
  const RoundedPath path({.points_m = {{0, 0}, {2, 0}}, .loop = true, .round_m = 0.0, .leave = false});
  EXPECT_DOUBLE_EQ(path.length_m(), 4.0);
  expect_on_path(path.pose_at(1.0), {1, 0}, 0.0);
  expect_on_path(path.pose_at(3.0), {1, 0}, kPi);
  EXPECT_NEAR(std::abs(path.pose_at(2.0).theta_rad), kPi / 2, kPathRounding);
}

TEST(RoundedPathTest, RefusesWhatIsNoPathAndSaysWhy) {
  const double nan = std::nan("");
  const auto expect_refused = [](const Path& path, const std::string& words) {
    try {
      validate_path(path, "walker 'anna'");
      ADD_FAILURE() << "accepted; expected: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("walker 'anna': path" + words), std::string::npos)
          << error.what();
    }
  };
  Path path = square(0.0);
  path.points_m = {};
  expect_refused(path, ": number of points: value 0");
  path.points_m = {{1, 1}};
  expect_refused(path, ": number of points: value 1 is out of range; allowed: >= 2");
  path.points_m = {{1, 1}, {1, nan}};
  expect_refused(path, ": coordinate");
  path.points_m = {{1, 1}, {2, 1}, {2, 1}};
  expect_refused(path, ": from point 1: length: value 0");
  path.points_m = {{1, 1}, {2, 1}, {1, 1}};
  expect_refused(path, ": from point 2: length: value 0");
  expect_refused(square(-0.1), ": from point 0: round: value -0.1");
  expect_refused(square(2.01), ": from point 0: round: value 2.01");
  expect_refused(square(nan), ": from point 0: round");
}

TEST(RoundedPathTest, ARadiusFitsUntilTheArcsMeet) {
  EXPECT_NO_THROW(validate_path(square(2.0), "x"));
  EXPECT_NEAR(RoundedPath(square(2.0)).length_m(), 4 * kPi, kPathRounding);
}

RC_GTEST_PROP(RoundedPathTest, ArcLengthIsArcLength, ()) {
  Path path;
  path.loop = *rc::gen::arbitrary<bool>();
  const auto codes = *rc::gen::container<std::vector<int>>(6, rc::gen::inRange(0, 1000000));
  for (const int code : codes) path.points_m.push_back(Vector2d(code % 1000, code / 1000) / 100.0);
  path.round_m = *rc::gen::element(0.0, 0.05, 0.2);
  try {
    validate_path(path, "x");
  } catch (const InputError&) {
    RC_DISCARD("no path");
  }
  const RoundedPath rounded(path);
  constexpr double kStep_m = 0.01;
  for (double s_m = 0.0; s_m + kStep_m < rounded.length_m(); s_m += kStep_m) {
    const Pose2 a = rounded.pose_at(s_m);
    const Pose2 b = rounded.pose_at(s_m + kStep_m);
    RC_ASSERT((b.p_m - a.p_m).norm() <= kStep_m + 1e-9);  // a chord is never longer than its arc
    const double turned_rad = std::abs(wrap_to_pi(b.theta_rad - a.theta_rad));
    if (path.round_m > 0.0) RC_ASSERT(turned_rad <= kStep_m / path.round_m + 1e-9);
  }
}

}  // namespace
}  // namespace scanbed::sim
