// SPDX-License-Identifier: MIT
#include "core/track/scan_matcher.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

struct Wall {
  Eigen::Vector2d a_m, b_m;
};

// A room with a recess and two columns, all sides of it at some angle to each other.
const std::vector<Wall> kRoom = {{{-2, -3}, {5, -3.2}}, {{5, -3.2}, {5.2, 0}},  {{5.2, 0}, {5.9, 0}},
                                 {{5.9, 0}, {6, 1.2}},  {{6, 1.2}, {5.1, 1.3}}, {{5.1, 1.3}, {5, 3.5}},
                                 {{5, 3.5}, {-2, 3.9}}, {{-2, 3.9}, {-2, -3}}};
const std::vector<Eigen::Vector2d> kColumns = {{3.0, 1.8}, {2.2, -1.9}};

LaserScan scan_from(const Pose2& X_WS, double sigma_m, unsigned seed) {
  const Pose2 X_SW = X_WS.inverse();
  testing::IdealScene scene;
  for (const Wall& wall : kRoom) scene.wall(X_SW * wall.a_m, X_SW * wall.b_m);
  for (const Eigen::Vector2d& column : kColumns) scene.cylinder(X_SW * column, 0.25);
  return testing::with_noise(scene.scan(), sigma_m, seed);
}

Points points_of(const LaserScan& scan) {
  PointProjector projector;
  Points points;
  projector.project(scan, points);
  return points;
}

ScanMatch match(const LaserScan& a, const LaserScan& b, const Pose2& expected_X_AB) {
  ScanMatcher matcher;
  matcher.set_reference(points_of(a), a.geometry);
  return matcher.match(points_of(b), expected_X_AB);
}

// A hundred points or more on each of several walls with 5 mm each leave some 5 mm / sqrt(100) and its lever.
constexpr double kNoiseLeft_m = 0.004;
constexpr double kNoiseLeft_rad = 0.002;

TEST(ScanMatcherTest, RecoversKnownMotions) {
  const LaserScan a = scan_from({}, 0.005, 1);
  const std::vector<Pose2> motions = {{},
                                      {{0.10, 0.0}, 0.0},
                                      {{0.20, 0.05}, 0.08},
                                      {{-0.15, -0.10}, -0.12},
                                      {{0.0, 0.0}, 0.17},
                                      {{0.3, 0.1}, -0.1}};
  unsigned seed = 2;
  for (const Pose2& X_AB : motions) {
    const ScanMatch found = match(a, scan_from(X_AB, 0.005, seed++), {});
    EXPECT_TRUE(found.is_trusted);
    EXPECT_NEAR((found.X_AB.p_m - X_AB.p_m).norm(), 0.0, kNoiseLeft_m) << X_AB.p_m.transpose();
    EXPECT_NEAR(wrap_to_pi(found.X_AB.theta_rad - X_AB.theta_rad), 0.0, kNoiseLeft_rad) << X_AB.theta_rad;
  }
}

// Angles that a wrong header may claim, and motions that cannot be: nothing is read beyond the scan, and what
// stood still is found all the same.
TEST(ScanMatcherTest, AnglesAndMotionsThatSayNothingDoNoHarm) {
  const LaserScan a = scan_from({}, 0.005, 1);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (const double step_rad : {0.0, 1e-12, 1e-308, HUGE_VAL, not_a_number}) {
    LaserScan wrong = a;
    wrong.geometry.step_rad = step_rad;
    EXPECT_FALSE(match(wrong, a, {}).is_trusted) << step_rad;
  }
  for (const double x_m : {1e300, HUGE_VAL, not_a_number}) {
    EXPECT_NEAR(match(a, a, {{x_m, 0.0}, 0.0}).X_AB.p_m.norm(), 0.0, kNoiseLeft_m) << x_m;
  }
}

TEST(ScanMatcherTest, RecoversRandomMotionsWithinItsReach) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> shift_m(-0.15, 0.15);
  std::uniform_real_distribution<double> turn_rad(-0.12, 0.12);
  for (unsigned trial = 0; trial < 40; ++trial) {
    const Pose2 X_WA{{shift_m(random), shift_m(random)}, turn_rad(random)};
    const Pose2 X_WB{{shift_m(random), shift_m(random)}, turn_rad(random)};
    const Pose2 X_AB = X_WA.inverse() * X_WB;
    const ScanMatch found =
        match(scan_from(X_WA, 0.005, 2 * trial), scan_from(X_WB, 0.005, 2 * trial + 1), {});
    EXPECT_NEAR((found.X_AB.p_m - X_AB.p_m).norm(), 0.0, kNoiseLeft_m) << trial;
    EXPECT_NEAR(wrap_to_pi(found.X_AB.theta_rad - X_AB.theta_rad), 0.0, kNoiseLeft_rad) << trial;
  }
}

TEST(ScanMatcherTest, FindsATurnThatNobodyExpected) {
  const ScanMatch found = match(scan_from({}, 0.005, 1), scan_from({{0.05, 0.0}, 0.4}, 0.005, 2), {});
  EXPECT_TRUE(found.is_trusted);
  EXPECT_NEAR(found.X_AB.theta_rad, 0.4, kNoiseLeft_rad);
}

TEST(ScanMatcherTest, IsNotLedAwayByWhatMovesItself) {
  const LaserScan a = scan_from({}, 0.005, 1);
  LaserScan b = scan_from({{0.1, 0.0}, 0.05}, 0.005, 2);
  // A crowd of 60 beams stands close to the sensor in one scan only.
  for (int beam = 140; beam < 200; ++beam) b.range_m[beam] = 1.0;
  const ScanMatch found = match(a, b, {});
  EXPECT_NEAR((found.X_AB.p_m - Eigen::Vector2d(0.1, 0.0)).norm(), 0.0, kNoiseLeft_m);
  EXPECT_NEAR(found.X_AB.theta_rad, 0.05, kNoiseLeft_rad);
}

TEST(ScanMatcherTest, AlongACorridorItKeepsWhatWasExpected) {
  testing::IdealScene corridor;
  corridor.wall({-50.0, 1.0}, {50.0, 1.0});
  corridor.wall({-50.0, -1.0}, {50.0, -1.0});
  LaserScan scan = corridor.scan();
  for (double& range_m : scan.range_m) range_m = range_m > 8.0 ? kNoEcho : range_m;
  const ScanMatch found = match(scan, scan, {{0.2, 0.05}, 0.02});
  EXPECT_NEAR(found.X_AB.p_m.x(), 0.2, 0.02);
  EXPECT_NEAR(found.X_AB.p_m.y(), 0.0, 0.002);
  EXPECT_NEAR(found.X_AB.theta_rad, 0.0, 0.002);
}

TEST(ScanMatcherTest, DoesNotTrustAnotherRoom) {
  testing::IdealScene elsewhere;
  elsewhere.wall({0.8, -2.0}, {0.9, 2.0});
  const ScanMatch found = match(scan_from({}, 0.005, 1), elsewhere.scan(), {{0.1, 0.0}, 0.0});
  EXPECT_FALSE(found.is_trusted);
  EXPECT_EQ(found.X_AB.p_m, Eigen::Vector2d(0.1, 0.0));
}

TEST(ScanMatcherTest, EmptyAndOddScansSayNothing) {
  const LaserScan room = scan_from({}, 0.005, 1);
  LaserScan empty = room;
  for (double& range_m : empty.range_m) range_m = kNoEcho;
  const Pose2 expected{{0.1, 0.2}, 0.3};
  EXPECT_FALSE(match(room, empty, expected).is_trusted);
  EXPECT_FALSE(match(empty, room, expected).is_trusted);
  EXPECT_EQ(match(empty, room, expected).X_AB.p_m, expected.p_m);
  LaserScan no_step = room;
  no_step.geometry.step_rad = 0.0;
  EXPECT_FALSE(match(no_step, room, expected).is_trusted);
}

}  // namespace
}  // namespace scanbed
