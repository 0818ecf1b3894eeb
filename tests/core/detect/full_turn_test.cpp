// SPDX-License-Identifier: MIT
#include "core/detect/full_turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/geometry/polar.hpp"

namespace scanbed {
namespace {

// Twelve beams, 30 degrees apart from -180 degrees on, that see 2 m but for the given beams, which see 1 m.
LaserScan turn_with_near_beams(int first, int last) {
  LaserScan scan;
  scan.geometry = {.num_beams = 12, .first_rad = -kPi, .step_rad = kPi / 6};
  scan.range_m.assign(12, 2.0);
  for (int i = first; i <= last; ++i) scan.range_m[i % 12] = 1.0;
  return scan;
}

Leg leg_of(const LaserScan& scan, int first, int last) {
  return {.beams = {first, last}, .middle_m = polar(scan.geometry.bearing_rad((first + last) / 2), 1.0)};
}

TEST(FullTurnTest, CountsTheBeamsOfATurn) {
  LaserScan scan = turn_with_near_beams(5, 6);
  EXPECT_EQ(num_beams_in_turn(scan), 12);
  scan.geometry.step_rad = -scan.geometry.step_rad;
  EXPECT_EQ(num_beams_in_turn(scan), 12);
  scan.range_m.push_back(scan.range_m.front());
  EXPECT_EQ(num_beams_in_turn(scan), 12);
  scan.range_m.push_back(2.0);
  EXPECT_EQ(num_beams_in_turn(scan), 0);
  scan.range_m.resize(11);
  EXPECT_EQ(num_beams_in_turn(scan), 0);
}

TEST(FullTurnTest, LessThanATurnIsLeftAsItIs) {
  FullTurn turn;
  LaserScan half;
  half.range_m.assign(361, 1.0);
  EXPECT_EQ(&turn.unroll(half), &half);
  LaserScan nearly = turn_with_near_beams(3, 5);
  nearly.range_m.pop_back();
  nearly.geometry.num_beams = 11;
  EXPECT_EQ(&turn.unroll(nearly), &nearly);
  Features features;
  features.legs = {leg_of(nearly, 3, 5)};
  turn.roll(features);
  EXPECT_EQ(features.legs[0].beams.first, 3);
  EXPECT_EQ(features.legs[0].middle_m, leg_of(nearly, 3, 5).middle_m);
}

TEST(FullTurnTest, TheMiddleTurnLooksNowhereTwice) {
  LaserScan scan = turn_with_near_beams(5, 6);
  EXPECT_EQ(num_beams_to_same_direction(scan.geometry), 12);
  EXPECT_EQ(middle_turn(scan).first, 0);
  EXPECT_EQ(middle_turn(scan).last, 11);
  FullTurn turn;
  const LaserScan& unrolled = turn.unroll(scan);
  EXPECT_EQ(middle_turn(unrolled).first, 4);
  EXPECT_EQ(middle_turn(unrolled).last, 4 + 11);
  for (const double step_rad : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    scan.geometry.step_rad = step_rad;
    EXPECT_EQ(middle_turn(scan).last, 11) << step_rad;
  }
}

// It begins with the near beams, and has a quarter of a turn and one beam before it and behind it.
TEST(FullTurnTest, UnrollsFromTheLargestStepOn) {
  FullTurn turn;
  for (const int num_repeated : {0, 1}) {
    LaserScan scan = turn_with_near_beams(5, 6);
    scan.range_m[5] = 0.9;
    scan.range_m.insert(scan.range_m.end(), num_repeated, scan.range_m.front());
    const LaserScan& unrolled = turn.unroll(scan);
    ASSERT_EQ(unrolled.num_beams(), 12 + 2 * 4);
    EXPECT_EQ(unrolled.range_m[4], 0.9);
    EXPECT_EQ(unrolled.range_m[5], 1.0);
    EXPECT_EQ(unrolled.range_m[16], 0.9);
    EXPECT_EQ(std::count(unrolled.range_m.begin(), unrolled.range_m.end(), 2.0), 16);
  }
}

TEST(FullTurnTest, TakesFeaturesBackOnceEach) {
  const LaserScan scan = turn_with_near_beams(11, 12);  // across the seam: 11 and 0
  FullTurn turn;
  const LaserScan& unrolled = turn.unroll(scan);
  Features features;
  for (int first = 0; first + 1 < unrolled.num_beams(); ++first) {
    if (unrolled.range_m[first] == 1.0 && unrolled.range_m[first + 1] == 1.0)
      features.legs.push_back(leg_of(unrolled, first, first + 1));
  }
  ASSERT_EQ(features.legs.size(), 2u);
  turn.roll(features);
  ASSERT_EQ(features.legs.size(), 1u);
  EXPECT_NEAR((features.legs[0].middle_m - polar(scan.geometry.bearing_rad(11), 1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(features.legs[0].beams.first, features.legs[0].beams.last);  // one of its two beams
}

// A wall at y = 1 from beam 2 to beam 4 of the scan, as the unrolled one sees it.
TEST(FullTurnTest, TurnsLinesWithTheirEquation) {
  FullTurn turn;
  const LaserScan& unrolled = turn.unroll(turn_with_near_beams(7, 7));
  const auto is_first_near = [&](int beam) { return unrolled.range_m[beam] == 1.0; };
  ASSERT_TRUE(is_first_near(4));  // beam 7: 30 degrees to the left of x
  const Pose2 X_US = Pose2{{0.0, 0.0}, kPi / 6}.inverse();
  Line line;
  line.beams = {5, 6};
  line.left_m = X_US * Eigen::Vector2d(0.5, 1.0);
  line.right_m = X_US * Eigen::Vector2d(-0.5, 1.0);
  Features features;
  features.lines = {line};
  turn.roll(features);
  ASSERT_EQ(features.lines.size(), 1u);
  EXPECT_EQ(features.lines[0].beams.first, 8);
  EXPECT_NEAR((features.lines[0].left_m - Eigen::Vector2d(0.5, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(*features.lines[0].slope, 0.0, 1e-12);
  EXPECT_NEAR(*features.lines[0].bias_m, 1.0, 1e-12);
}

}  // namespace
}  // namespace scanbed
