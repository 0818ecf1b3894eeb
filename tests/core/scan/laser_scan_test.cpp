// SPDX-License-Identifier: MIT
#include "core/scan/laser_scan.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

// Each beam's range is its number.
LaserScan numbered(const ScanGeometry& geometry) {
  LaserScan scan{.geometry = geometry};
  for (int i = 0; i < geometry.num_beams; ++i) scan.range_m.push_back(i);
  return scan;
}

TEST(LaserScanTest, RangeTowardsIsThatOfTheNearestBeam) {
  const LaserScan half_turn = numbered({});
  EXPECT_EQ(range_towards(half_turn, -kPi / 2), 0.0);
  EXPECT_EQ(range_towards(half_turn, radians(0.2)), 180.0);
  EXPECT_EQ(range_towards(half_turn, radians(0.3)), 181.0);
  EXPECT_EQ(range_towards(half_turn, radians(90.2)), 360.0);
  EXPECT_EQ(range_towards(half_turn, radians(90.3)), kNoEcho);
  EXPECT_EQ(range_towards(half_turn, kPi), kNoEcho);
}

TEST(LaserScanTest, RangeTowardsGoesAllAround) {
  // From 0 to 359 degrees and the other way round, as some sensors count.
  const LaserScan up = numbered({.num_beams = 360, .first_rad = 0.0, .step_rad = radians(1.0)});
  const LaserScan down = numbered({.num_beams = 360, .first_rad = 0.0, .step_rad = radians(-1.0)});
  EXPECT_EQ(range_towards(up, radians(-90.0)), 270.0);
  EXPECT_EQ(range_towards(down, radians(-90.0)), 90.0);
  EXPECT_EQ(range_towards(up, radians(-0.4)), 0.0);
  EXPECT_EQ(range_towards(up, radians(359.7)), 0.0);
}

TEST(LaserScanTest, NoBeamPointsAnywhereWhereAnglesSayNothing) {
  EXPECT_EQ(range_towards(numbered({.num_beams = 2, .step_rad = 0.0}), 0.0), kNoEcho);
  EXPECT_EQ(range_towards(numbered({.num_beams = 0}), 0.0), kNoEcho);
}

}  // namespace
}  // namespace scanbed
