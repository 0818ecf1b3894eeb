// SPDX-License-Identifier: MIT
#include "core/detect/leg_detector.hpp"

#include <gtest/gtest.h>

#include "core/detect/feature_detector.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

std::vector<Leg> legs_of(const LaserScan& scan, const LegOptions& leg = {}) {
  DetectorOptions options = paper_options();
  options.leg = leg;
  return FeatureDetector(options).detect(scan).legs;
}

std::vector<Leg> legs_at(const Eigen::Vector2d& center_m, double radius_m) {
  IdealScene scene;
  scene.cylinder(center_m, radius_m, Primitive::kLeg);
  return legs_of(scene.scan());
}

TEST(LegDetectorTest, FindsALegAtItsFront) {
  const auto legs = legs_at({2.0, 0.3}, 0.07);
  ASSERT_EQ(legs.size(), 1u);
  // The middle point lies on the surface: one radius before the centre, give or take half a beam spacing.
  EXPECT_NEAR((legs[0].middle_m - Eigen::Vector2d(2.0, 0.3)).norm(), 0.07, 0.01);
}

TEST(LegDetectorTest, AcceptsChordsOf10To25CentimetresOnly) {
  EXPECT_EQ(legs_at({1.0, 0.0}, 0.06).size(), 1u);
  EXPECT_TRUE(legs_at({1.0, 0.0}, 0.04).empty());
  EXPECT_EQ(legs_at({1.0, 0.0}, 0.12).size(), 1u);
  EXPECT_TRUE(legs_at({1.0, 0.0}, 0.14).empty());
}

TEST(LegDetectorTest, ALegPartlyHiddenByAnotherThingIsNone) {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.07, Primitive::kLeg);
  scene.cylinder({1.0, -0.05}, 0.04);
  EXPECT_TRUE(legs_of(scene.scan()).empty());
}

TEST(LegDetectorTest, AThingBehindHidesNothing) {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.07, Primitive::kLeg);
  scene.wall({3.0, -2.0}, {3.0, 2.0});
  EXPECT_EQ(legs_of(scene.scan()).size(), 1u);
}

TEST(LegDetectorTest, ALegCutByTheEdgeOfViewIsNone) {
  EXPECT_TRUE(legs_at({0.0, -1.0}, 0.09).empty());
  EXPECT_EQ(legs_at({0.2, -1.0}, 0.09).size(), 1u);
}

TEST(LegDetectorTest, ATooCloseNeighbourHidesAndAnInvalidOneDoesNot) {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.07, Primitive::kLeg);
  LaserScan scan = scene.scan();
  int first = 0;
  while (!scan.has_echo(first)) ++first;
  scan.range_m[first - 1] = kInvalid;
  EXPECT_EQ(legs_of(scan).size(), 1u);
  scan.range_m[first - 1] = kTooClose;
  EXPECT_TRUE(legs_of(scan).empty());
}

TEST(LegDetectorTest, ThreePointsAreEnoughAndTwoAreNot) {
  // Beams at -0.5, 0 and 0.5 degrees; at 6.2 m their chord on a leg of 0.07 m is 0.107 m, wide enough.
  EXPECT_EQ(legs_at({6.2, 0.0}, 0.07).size(), 1u);
  EXPECT_TRUE(legs_at({7.0, 0.031}, 0.06).empty());  // 0.98 degrees wide: two beams
}

TEST(LegDetectorTest, OnAFullCircleTheNeighboursAcrossTheSeamCount) {
  ScanGeometry all_round{.num_beams = 720, .first_rad = -kPi, .step_rad = kPi / 360};
  IdealScene scene(all_round);
  // Its first beam is beam 0; the beam before that, number 719, passes it by.
  scene.cylinder(2.0 * Eigen::Vector2d(std::cos(-kPi + 0.035), std::sin(-kPi + 0.035)), 0.07,
                 Primitive::kLeg);
  const LaserScan scan = scene.scan();
  ASSERT_TRUE(scan.has_echo(0));
  ASSERT_FALSE(scan.has_echo(719));
  EXPECT_EQ(legs_of(scan).size(), 1u);
}

}  // namespace
}  // namespace scanbed
