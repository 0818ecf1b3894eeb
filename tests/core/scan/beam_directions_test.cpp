// SPDX-License-Identifier: MIT
#include "core/scan/beam_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed {
namespace {

LaserScan scan_of(int num_beams, double first_rad, double step_rad) {
  LaserScan scan;
  scan.geometry.first_rad = first_rad;
  scan.geometry.step_rad = step_rad;
  scan.range_m.assign(num_beams, 1.0);
  return scan;
}

TEST(BeamDirectionsTest, BeamZeroOfALaserOf180DegreesPointsToTheRight) {
  BeamDirections directions;
  directions.follow(scan_of(3, -kPi / 2, kPi / 2));
  ASSERT_EQ(directions.num_beams(), 3);
  for (const auto& [beam, x, y] : {std::tuple{0, 0.0, -1.0}, {1, 1.0, 0.0}, {2, 0.0, 1.0}}) {
    EXPECT_NEAR(directions.x(beam), x, 1e-15);
    EXPECT_NEAR(directions.y(beam), y, 1e-15);
  }
}

TEST(BeamDirectionsTest, FollowsEachChangeOfTheGeometry) {
  BeamDirections directions;
  for (const auto& [num_beams, first_rad, step_rad] :
       {std::tuple{5, 0.0, 0.1}, {7, 0.0, 0.1}, {7, 0.3, 0.1}, {7, 0.3, -0.1}, {4, 0.3, -0.1}}) {
    directions.follow(scan_of(num_beams, first_rad, step_rad));
    ASSERT_EQ(directions.num_beams(), num_beams);
    for (int i = 0; i < num_beams; ++i) {
      EXPECT_EQ(directions.x(i), std::cos(first_rad + i * step_rad));
      EXPECT_EQ(directions.y(i), std::sin(first_rad + i * step_rad));
    }
  }
}

TEST(BeamDirectionsTest, TrustsTheRangesOverTheirPromisedNumber) {
  LaserScan scan = scan_of(2, 0.0, 0.1);
  scan.geometry.num_beams = 361;
  BeamDirections directions;
  directions.follow(scan);
  EXPECT_EQ(directions.num_beams(), 2);
  directions.follow({});
  EXPECT_EQ(directions.num_beams(), 0);
}

}  // namespace
}  // namespace scanbed
