// SPDX-License-Identifier: MIT
#include "core/detect/circle_detector.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/arc_points.hpp"

namespace scanbed {
namespace {

using testing::all_of;
using testing::append;
using testing::arc;

std::optional<Circle> circle_of(const Points& points, const CircleOptions& options = {}) {
  return detect_circle(points, all_of(points), options);
}

TEST(CircleDetectorTest, RecoversCentreAndRadiusOfAnExactArc) {
  for (const double central_deg : {91.0, 120.0, 150.0, 179.0}) {
    const auto circle = circle_of(arc({3.0, 1.0}, 0.25, radians(central_deg), 13));
    ASSERT_TRUE(circle) << central_deg;
    EXPECT_NEAR((circle->center_m - Eigen::Vector2d(3.0, 1.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(circle->radius_m, 0.25, 1e-9);
    EXPECT_NEAR(circle->average_rad.value(), kPi - radians(central_deg) / 2, 1e-9);
    EXPECT_EQ(circle->beams.first, 0);
    EXPECT_EQ(circle->beams.last, 12);
  }
}

TEST(CircleDetectorTest, AcceptsAveragesFrom90To135DegreesOnly) {
  EXPECT_TRUE(circle_of(arc({3.0, 0.0}, 0.25, radians(90.5), 13)));    // average 134.75
  EXPECT_FALSE(circle_of(arc({3.0, 0.0}, 0.25, radians(89.5), 13)));   // 135.25
  EXPECT_TRUE(circle_of(arc({3.0, 0.0}, 0.25, radians(179.5), 13)));   // 90.25
  EXPECT_FALSE(circle_of(arc({3.0, 0.0}, 0.25, radians(181.0), 13)));  // 89.5
}

TEST(CircleDetectorTest, NeedsTheLeastNumberOfPointsAndTheLengthBand) {
  EXPECT_FALSE(circle_of(arc({3.0, 0.0}, 0.25, radians(120), 3)));
  EXPECT_TRUE(circle_of(arc({3.0, 0.0}, 0.25, radians(120), 4)));
  // Chord 2 R sin(60 deg): 0.150 m at R = 0.0866.
  EXPECT_FALSE(circle_of(arc({3.0, 0.0}, 0.0860, radians(120), 9)));
  EXPECT_TRUE(circle_of(arc({3.0, 0.0}, 0.0872, radians(120), 9)));
  EXPECT_FALSE(circle_of(arc({3.0, 0.0}, 0.25, radians(120), 9), {.max_length_m = 0.4}));
}

TEST(CircleDetectorTest, StraightRunsAreNoCircles) {
  Points points;
  for (int i = 0; i < 20; ++i) append(points, {3.0, 0.05 * i});
  EXPECT_FALSE(circle_of(points));
  EXPECT_FALSE(circle_of(points, {.prerequisite = false}));
}

TEST(CircleDetectorTest, AHollowIsNoCircleEvenWithoutThePrerequisite) {
  Points hollow = arc({3.0, 0.0}, 0.3, radians(120), 13);
  for (double& x_m : hollow.x_m) x_m = 5.0 - x_m;  // mirrored: bulges away from the sensor
  EXPECT_FALSE(circle_of(hollow));
  EXPECT_FALSE(circle_of(hollow, {.prerequisite = false}));
}

TEST(CircleDetectorTest, APointThatNoisePutsBehindTheChordSpoilsNoArc) {
  Points points = arc({3.0, 0.0}, 0.3, radians(140), 31);
  points.x_m[1] = points.x_m[0] + 0.004;  // next to the end, 4 mm too far
  const auto circle = circle_of(points);
  ASSERT_TRUE(circle);
  EXPECT_NEAR((circle->center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 0.02);
}

Points trunk() {  // bark: radius 0.3 m give or take 5 %, in no even pattern
  Points points = arc({3.0, 0.0}, 0.3, radians(150), 15);
  const double swell_ratio[] = {1.0,  1.02, 0.95, 1.05, 0.97, 1.0,  0.95, 1.04,
                                1.05, 0.95, 1.0,  1.05, 0.95, 1.03, 1.0};
  for (int k = 0; k < points.size(); ++k) {
    points.x_m[k] = 3.0 + swell_ratio[k] * (points.x_m[k] - 3.0);
    points.y_m[k] *= swell_ratio[k];
  }
  return points;
}

TEST(CircleDetectorTest, ArcLikeShapesNeedAWiderThreshold) {
  const CircleOptions wide{.max_std_rad = radians(23.0)};
  const auto angles_like_a_trunk = circle_of(trunk(), wide);
  ASSERT_TRUE(angles_like_a_trunk);
  EXPECT_NEAR((angles_like_a_trunk->center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 0.1);
  const CircleOptions tight{.max_std_rad = angles_like_a_trunk->std_rad.value() * 0.99};
  EXPECT_FALSE(circle_of(trunk(), tight));
}

TEST(CircleDetectorTest, AVCornerIsNoArcLikeShape) {
  Points points;  // 100 degrees, towards the sensor
  for (int i = -8; i <= 8; ++i) append(points, {2.0 + 0.04 * std::abs(i) / std::tan(radians(50)), 0.04 * i});
  const auto angles_spread = [&] {
    CircleOptions anything{.max_std_rad = radians(23.0), .min_average_rad = 0.1, .max_average_rad = 3.1};
    return circle_of(points, anything);
  };
  EXPECT_FALSE(angles_spread());
  points.x_m[9] += 0.03;  // a dent beside the tip: the angles no longer grow evenly
  EXPECT_TRUE(angles_spread());
}

TEST(CircleDetectorTest, ScoresHalfACircleOfManyPointsAboveAFlatArcOfFew) {
  const auto good = circle_of(arc({3.0, 0.0}, 0.25, radians(179), 25));
  const auto poor = circle_of(arc({3.0, 0.0}, 0.25, radians(92), 5));
  ASSERT_TRUE(good && poor);
  EXPECT_GT(good->score, poor->score);
  EXPECT_LE(good->score, 1.0);
  EXPECT_GE(poor->score, 0.0);
}

TEST(CircleDetectorTest, PointsThatCoincideAreNoCircle) {
  Points points;
  for (int i = 0; i < 6; ++i) append(points, {1.0, 1.0});
  EXPECT_FALSE(circle_of(points, {.min_length_m = 0.0, .prerequisite = false}));
}

RC_GTEST_PROP(CircleDetectorTest, FindsEveryExactArcWhereverItStands, ()) {
  const double central_deg = *rc::gen::inRange(92, 178);
  const double radius_m = *rc::gen::inRange(12, 100) / 100.0;
  const double bearing_deg = *rc::gen::inRange(-180, 180);
  const double range_m = radius_m + *rc::gen::inRange(5, 800) / 100.0;
  const Eigen::Vector2d center_m =
      range_m * Eigen::Vector2d(std::cos(radians(bearing_deg)), std::sin(radians(bearing_deg)));
  const auto circle = circle_of(arc(center_m, radius_m, radians(central_deg), 9));
  RC_ASSERT(circle.has_value());
  RC_ASSERT((circle->center_m - center_m).norm() < 1e-6);
  RC_ASSERT(std::abs(circle->radius_m - radius_m) < 1e-6);
}

}  // namespace
}  // namespace scanbed
