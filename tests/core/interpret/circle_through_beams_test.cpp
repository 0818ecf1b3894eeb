// SPDX-License-Identifier: MIT
#include "core/interpret/circle_through_beams.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

LaserScan column_scan() {
  testing::IdealScene hall;
  hall.cylinder({3.0, 0.0}, 0.4);
  return hall.scan();
}

TEST(CircleThroughBeamsTest, FindsTheCircleOfTwoArcs) {
  const LaserScan scan = column_scan();
  CircleThroughBeams circle({{3.05, 0.04}, 0.33});
  for (int step = 0; step < 8; ++step) {
    circle.add(scan, {167, 174});
    circle.add(scan, {186, 193});
    ASSERT_TRUE(circle.step());
  }
  EXPECT_NEAR((circle.fit().center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(circle.fit().radius_m, 0.4, 1e-6);
}

TEST(CircleThroughBeamsTest, TooFewEchoesLeaveItAsItWas) {
  const LaserScan scan = column_scan();
  CircleThroughBeams circle({{3.0, 0.0}, 0.4});
  circle.add(scan, {180, 180});
  EXPECT_FALSE(circle.step());
  circle.add(scan, {0, 5});  // no echo there
  EXPECT_FALSE(circle.step());
  EXPECT_EQ(circle.fit().center_m, Eigen::Vector2d(3.0, 0.0));
}

}  // namespace
}  // namespace scanbed
