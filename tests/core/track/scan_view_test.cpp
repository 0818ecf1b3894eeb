// SPDX-License-Identifier: MIT
#include "core/track/scan_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

LaserScan hall_with_column() {
  testing::IdealScene hall;
  hall.wall({6.0, -10.0}, {6.0, 10.0});
  hall.cylinder({3.0, 0.0}, 0.3);
  return hall.scan();
}

TEST(ScanViewTest, TellsWhatBeamsSayOfAPlace) {
  const LaserScan scan = hall_with_column();
  EXPECT_EQ(view_of(scan, {3.0, 0.0}, 0.3), PlaceView::kOccupied);
  EXPECT_EQ(view_of(scan, {4.5, 0.0}, 0.25), PlaceView::kHidden);
  EXPECT_EQ(view_of(scan, {3.0, 1.5}, 0.25), PlaceView::kEmpty);
  EXPECT_EQ(view_of(scan, {-3.0, 0.1}, 0.25), PlaceView::kOutOfView);
}

TEST(ScanViewTest, NoEchoIsAPlaceSeenThrough) {
  LaserScan scan = hall_with_column();
  for (double& range_m : scan.range_m) range_m = kNoEcho;
  EXPECT_EQ(view_of(scan, {3.0, 0.0}, 0.3), PlaceView::kEmpty);
}

TEST(ScanViewTest, ABlindScanSeesNothing) {
  LaserScan scan = hall_with_column();
  for (double& range_m : scan.range_m) range_m = kInvalid;
  EXPECT_EQ(view_of(scan, {3.0, 0.0}, 0.3), PlaceView::kOutOfView);
  EXPECT_EQ(view_of(LaserScan{.geometry = {.num_beams = 0}}, {3.0, 0.0}, 0.3), PlaceView::kOutOfView);
}

// Of 361 beams at half a degree, a cylinder of 0.05 m at 2 m meets those within asin(0.05 / 2) = 1.4 degrees.
TEST(ScanViewTest, CountsEchoesNearAPlace) {
  testing::IdealScene hall;
  hall.wall({6.0, -10.0}, {6.0, 10.0});
  hall.cylinder({2.0, 0.0}, 0.05);
  const LaserScan scan = hall.scan();
  EXPECT_EQ(num_echoes_near(scan, {2.0, 0.0}, 0.1), 5);
  EXPECT_EQ(num_echoes_near(scan, {2.0, 0.3}, 0.4), 5);
  EXPECT_EQ(num_echoes_near(scan, {2.0, 0.6}, 0.4), 0);
  EXPECT_EQ(num_echoes_near(scan, {0.1, 0.0}, 0.4), 0);
  EXPECT_EQ(num_echoes_near(LaserScan{.geometry = {.num_beams = 0}}, {2.0, 0.0}, 0.4), 0);
}

// Steps that a wrong header may claim: no beam points there, and nothing is read beyond the scan.
TEST(ScanViewTest, StepsThatSayNothingShowNothing) {
  LaserScan scan = hall_with_column();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (const double step_rad : {0.0, 1e-12, -1e-12, 1e-200, 1e-308, HUGE_VAL, not_a_number}) {
    scan.geometry.step_rad = step_rad;
    EXPECT_EQ(view_of(scan, {3.0, 0.0}, 0.3), PlaceView::kOutOfView) << step_rad;
    EXPECT_EQ(num_echoes_near(scan, {3.0, 0.0}, 0.3), 0) << step_rad;
  }
  scan.geometry.step_rad = kPi / 360;
  scan.geometry.first_rad = not_a_number;
  EXPECT_EQ(view_of(scan, {3.0, 0.0}, 0.3), PlaceView::kOutOfView);
}

TEST(ScanViewTest, FollowsAClockwiseAndAFullTurn) {
  ScanGeometry clockwise;
  clockwise.first_rad = kPi / 2;
  clockwise.step_rad = -clockwise.step_rad;
  ScanGeometry full_turn{.num_beams = 720, .first_rad = 0.0, .step_rad = kPi / 360};
  for (const ScanGeometry& geometry : {clockwise, full_turn}) {
    testing::IdealScene hall(geometry);
    hall.wall({6.0, -10.0}, {6.0, 10.0});
    hall.cylinder({3.0, -2.0}, 0.3);
    EXPECT_EQ(view_of(hall.scan(), {3.0, -2.0}, 0.3), PlaceView::kOccupied);
    EXPECT_EQ(view_of(hall.scan(), {4.2, -2.8}, 0.2), PlaceView::kHidden);
    EXPECT_EQ(view_of(hall.scan(), {3.0, 2.0}, 0.3), PlaceView::kEmpty);
  }
}

}  // namespace
}  // namespace scanbed
