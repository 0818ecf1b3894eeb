// SPDX-License-Identifier: MIT
#include "core/detect/inscribed_angles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/geometry/angles.hpp"
#include "tests/support/arc_points.hpp"

namespace scanbed {
namespace {

using testing::all_of;
using testing::append;
using testing::arc;

TEST(InscribedAnglesTest, OnAnArcEveryAngleIsHalfTheReflexCentralAngle) {
  // Euclid III.20: the inner points see the chord under 180 degrees less half the arc's central angle.
  for (const double central_deg : {60.0, 90.0, 120.0, 180.0}) {
    const Points points = arc({2.0, -1.0}, 0.4, radians(central_deg), 15);
    const auto angles = inscribed_angles(points, all_of(points), BehindChord::kReflex);
    ASSERT_TRUE(angles);
    EXPECT_NEAR(angles->average_rad, kPi - radians(central_deg) / 2, 1e-9);
    EXPECT_NEAR(angles->std_rad, 0.0, 1e-7);
  }
}

TEST(InscribedAnglesTest, OnALineTheyAre180DegreesAlsoWhereNoiseCrossesIt) {
  Points points;
  for (int i = 0; i <= 20; ++i) append(points, {3.0 + (i % 2 == 0 ? 1e-4 : -1e-4), -0.5 + 0.05 * i});
  const auto angles = inscribed_angles(points, all_of(points), BehindChord::kReflex);
  ASSERT_TRUE(angles);
  EXPECT_NEAR(angles->average_rad, kPi, 0.01);
  EXPECT_LT(angles->std_rad, 0.01);
}

TEST(InscribedAnglesTest, BehindTheChordTheyExceed180Degrees) {
  Points points;
  append(points, {2.0, -0.2});
  append(points, {2.2, 0.0});
  append(points, {2.0, 0.2});
  EXPECT_NEAR(inscribed_angles(points, all_of(points), BehindChord::kReflex)->average_rad, 1.5 * kPi, 1e-9);
}

TEST(InscribedAnglesTest, FoldedAPointBehindTheChordCountsAsIfInFrontOfIt) {
  Points points;
  append(points, {2.0, -0.2});
  append(points, {2.2, 0.0});
  append(points, {2.0, 0.2});
  EXPECT_NEAR(inscribed_angles(points, all_of(points), BehindChord::kFolded)->average_rad, 0.5 * kPi, 1e-9);
}

TEST(InscribedAnglesTest, FewerThanThreePointsHaveNone) {
  Points points;
  append(points, {1.0, 0.0});
  EXPECT_FALSE(inscribed_angles(points, {0, 0}, BehindChord::kFolded));
  append(points, {1.0, 0.1});
  EXPECT_FALSE(inscribed_angles(points, {0, 1}, BehindChord::kFolded));
}

Points corner(int num_each_side) {  // a right angle that points at the sensor
  Points points;
  for (int i = -num_each_side; i <= num_each_side; ++i) append(points, {2.0 + 0.03 * std::abs(i), 0.03 * i});
  return points;
}

TEST(InscribedAnglesTest, AVCornerIsTold) {
  const Points points = corner(6);
  EXPECT_TRUE(is_v_corner(points, all_of(points)));
}

TEST(InscribedAnglesTest, AnArcWhoseSmallestAngleStandsAloneIsNoCorner) {
  Points points = arc({2.0, 0.0}, 0.3, radians(120.0), 15);
  points.x_m[7] -= 0.01;  // one point nearer, its neighbours as they were
  points.x_m[6] += 0.004;
  points.x_m[9] -= 0.006;  // and one more, so that the angles do not grow evenly
  EXPECT_FALSE(is_v_corner(points, all_of(points)));
}

TEST(InscribedAnglesTest, TheVTestNeverLooksOutsideTheSegment) {
  for (int num_each_side = 1; num_each_side <= 2; ++num_each_side) {
    const Points points = corner(num_each_side);  // the minimum lacks inner neighbours
    EXPECT_FALSE(is_v_corner(points, all_of(points))) << num_each_side;
  }
  const Points points = corner(6);
  EXPECT_FALSE(is_v_corner(points, {5, 7}));
}

RC_GTEST_PROP(InscribedAnglesTest, DoNotChangeWhenTheScanIsMirrored, ()) {
  const double central_deg = *rc::gen::inRange(20, 180);
  const double x_m = *rc::gen::inRange(10, 60) / 10.0;
  const double y_m = *rc::gen::inRange(-30, 30) / 10.0;
  Points points = arc({x_m, y_m}, 0.3, radians(central_deg), 9);
  const auto angles = inscribed_angles(points, all_of(points), BehindChord::kReflex);
  for (double& y : points.y_m) y = -y;
  const auto mirrored = inscribed_angles(points, all_of(points), BehindChord::kReflex);
  RC_ASSERT(std::abs(angles->average_rad - mirrored->average_rad) < 1e-9);
}

}  // namespace
}  // namespace scanbed
