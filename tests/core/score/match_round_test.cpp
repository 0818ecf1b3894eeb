// SPDX-License-Identifier: MIT
#include "core/score/match_round.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

Circle circle_at(Eigen::Vector2d center_m, double radius_m, BeamSpan beams = {0, 1}) {
  Circle circle;
  circle.center_m = center_m;
  circle.radius_m = radius_m;
  circle.beams = beams;
  return circle;
}

Leg leg_at(Eigen::Vector2d middle_m, BeamSpan beams = {0, 1}) {
  Leg leg;
  leg.middle_m = middle_m;
  leg.beams = beams;
  return leg;
}

Tally circles_in(const IdealScene& scene, const std::vector<Circle>& circles) {
  return match_circles(circles, scene.truth(), {}).tally;
}

Tally legs_in(const IdealScene& scene, const std::vector<Leg>& legs) {
  return match_legs(legs, scene.truth(), {}).tally;
}

IdealScene column_ahead() {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.25);
  return scene;
}

TEST(MatchRoundTest, CentreAndRadiusMustBothFit) {
  const Tally right = circles_in(column_ahead(), {circle_at({2.06, 0.0}, 0.29)});
  EXPECT_EQ(right.num_found, 1);
  EXPECT_NEAR(right.rms_error_m(), 0.06, 1e-12);
  EXPECT_EQ(circles_in(column_ahead(), {circle_at({2.11, 0.0}, 0.25)}).num_right, 0);
  EXPECT_EQ(circles_in(column_ahead(), {circle_at({2.0, 0.0}, 0.31)}).num_right, 0);
}

TEST(MatchRoundTest, ATruthIsMatchedOnceByTheNearest) {
  const Tally tally =
      circles_in(column_ahead(), {circle_at({2.05, 0.0}, 0.25), circle_at({2.01, 0.0}, 0.25)});
  EXPECT_EQ(tally.num_detections, 2);
  EXPECT_EQ(tally.num_right, 1);
  EXPECT_NEAR(tally.rms_error_m(), 0.01, 1e-12);
}

TEST(MatchRoundTest, ACircleOnALegIsNeitherRightNorWrong) {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.07, Primitive::kLeg);
  const Tally tally =
      circles_in(scene, {circle_at({2.0, 0.0}, 0.07, {177, 183})});  // 4 degrees: beams 176 to 184
  EXPECT_EQ(tally.num_neither, 1);
  EXPECT_EQ(tally.num_detections, 0);
}

TEST(MatchRoundTest, ACircleOnAWallIsWrong) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.0, 1.0});
  EXPECT_EQ(circles_in(scene, {circle_at({2.2, 0.0}, 0.2, {170, 190})}).num_detections, 1);
}

TEST(MatchRoundTest, WhatNeedNotBeFoundIsNeitherHitNorMiss) {
  IdealScene scene;
  scene.cylinder({0.0, -3.0}, 0.25);  // cut by the edge of view
  const Tally found = circles_in(scene, {circle_at({0.0, -3.0}, 0.25)});
  EXPECT_EQ(found.num_truths, 0);
  EXPECT_EQ(found.num_neither, 1);
  const Tally bad_fit = circles_in(scene, {circle_at({0.3, -3.2}, 0.5, {0, 8})});
  EXPECT_EQ(bad_fit.num_neither, 1);
}

TEST(MatchRoundTest, LegsMatchWithinFifteenCentimetres) {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.07, Primitive::kLeg);
  EXPECT_EQ(legs_in(scene, {leg_at({1.93, 0.0})}).num_found, 1);
  EXPECT_EQ(legs_in(scene, {leg_at({1.84, 0.0})}).num_found, 0);
}

TEST(MatchRoundTest, ALegOnANarrowCylinderIsNeitherAndOnAWideOneWrong) {
  IdealScene narrow;
  narrow.cylinder({2.0, 0.0}, 0.12);
  EXPECT_EQ(legs_in(narrow, {leg_at({1.88, 0.0}, {174, 186})}).num_neither, 1);
  IdealScene wide;
  wide.cylinder({2.0, 0.0}, 0.13);
  EXPECT_EQ(legs_in(wide, {leg_at({1.87, 0.0}, {174, 186})}).num_detections, 1);
}

TEST(MatchRoundTest, TwoLegsNeedTwoDetections) {
  IdealScene scene;
  scene.cylinder({2.0, -0.1}, 0.06, Primitive::kLeg);
  scene.cylinder({2.0, 0.1}, 0.06, Primitive::kLeg);
  EXPECT_EQ(legs_in(scene, {leg_at({1.94, 0.0})}).num_found, 1);
  EXPECT_EQ(legs_in(scene, {leg_at({1.94, -0.1}), leg_at({1.94, 0.1})}).num_found, 2);
}

}  // namespace
}  // namespace scanbed
