// SPDX-License-Identifier: MIT
#include "core/detect/points.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

LaserScan scan_of(std::vector<double> range_m, double first_rad, double step_rad) {
  LaserScan scan;
  scan.geometry.num_beams = static_cast<int>(range_m.size());
  scan.geometry.first_rad = first_rad;
  scan.geometry.step_rad = step_rad;
  scan.range_m = std::move(range_m);
  return scan;
}

TEST(PointProjectorTest, PutsBeamZeroOnTheRightAndXForward) {
  Points points;
  PointProjector().project(scan_of({1.0, 2.0, 3.0}, -kPi / 2, kPi / 2), points);
  ASSERT_EQ(points.size(), 3);
  EXPECT_NEAR((points[0] - Eigen::Vector2d(0.0, -1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((points[1] - Eigen::Vector2d(2.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((points[2] - Eigen::Vector2d(0.0, 3.0)).norm(), 0.0, 1e-12);
}

TEST(PointProjectorTest, LeavesOutBeamsWithoutEchoAndKeepsTheirNumbers) {
  Points points;
  PointProjector().project(scan_of({kNoEcho, 1.0, kInvalid, kTooClose, 2.0}, 0.0, 0.1), points);
  EXPECT_EQ(points.beam, (std::vector<int>{1, 4}));
}

TEST(PointProjectorTest, FollowsAGeometryThatChangesFromScanToScan) {
  Points points;
  PointProjector projector;
  projector.project(scan_of({1.0}, 0.0, 0.1), points);
  EXPECT_NEAR(points.x_m[0], 1.0, 1e-12);
  projector.project(scan_of({1.0}, kPi / 2, 0.1), points);
  EXPECT_NEAR(points.y_m[0], 1.0, 1e-12);
}

TEST(PointProjectorTest, TrustsTheRangesOverTheirPromisedNumber) {
  LaserScan scan = scan_of({1.0, 1.0}, 0.0, 0.1);
  scan.geometry.num_beams = 361;
  Points points;
  PointProjector().project(scan, points);
  EXPECT_EQ(points.size(), 2);
}

TEST(PointProjectorTest, AnEmptyScanHasNoPoints) {
  Points points;
  PointProjector().project(scan_of({}, 0.0, 0.1), points);
  EXPECT_EQ(points.size(), 0);
}

}  // namespace
}  // namespace scanbed
