// SPDX-License-Identifier: MIT
#include "core/track/ego_motion.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

LaserScan scan_from(const Pose2& X_WS, double time_s) {
  const Pose2 X_SW = X_WS.inverse();
  testing::IdealScene scene;
  const Eigen::Vector2d corners_m[] = {{-4, -3}, {6, -3.4}, {6.3, 0}, {7, 0.2}, {6.8, 3}, {-4, 4}, {-4, -3}};
  for (int i = 0; i + 1 < 7; ++i) scene.wall(X_SW * corners_m[i], X_SW * corners_m[i + 1]);
  scene.cylinder(X_SW * Eigen::Vector2d(3.0, 1.5), 0.3);
  LaserScan scan = testing::with_noise(scene.scan(), 0.005, static_cast<unsigned>(time_s * 1000));
  scan.time_s = time_s;
  return scan;
}

Pose2 on_a_curve(double time_s) {
  const double angle_rad = 0.3 * time_s;
  return {{1.5 * std::sin(angle_rad), 1.5 * (1.0 - std::cos(angle_rad))}, angle_rad};
}

TEST(EgoMotionTest, FollowsADriveAlongACurve) {
  EgoMotion ego;
  for (int i = 0; i <= 50; ++i) {
    const Pose2 X_WS = on_a_curve(0.1 * i);
    const Pose2& found = ego.update(scan_from(X_WS, 0.1 * i));
    // References change every 0.3 m or 0.2 rad, here about ten times; each adds its few millimetres.
    EXPECT_NEAR((found.p_m - X_WS.p_m).norm(), 0.0, 0.02) << i;
    EXPECT_NEAR(wrap_to_pi(found.theta_rad - X_WS.theta_rad), 0.0, 0.01) << i;
  }
}

TEST(EgoMotionTest, DoesNotDriftWhileTheSensorStands) {
  EgoMotion ego;
  for (int i = 0; i < 100; ++i) ego.update(scan_from({{0.5, 0.2}, 0.1}, 0.1 * i));
  EXPECT_NEAR(ego.pose().p_m.norm(), 0.0, 0.005);
  EXPECT_NEAR(ego.pose().theta_rad, 0.0, 0.002);
}

TEST(EgoMotionTest, OdometryAloneIsTakenAsItIs) {
  EgoMotion ego(MotionSource::kOdometry);
  for (int i = 0; i <= 10; ++i) {
    LaserScan scan = scan_from({}, 0.1 * i);
    scan.X_OR = Pose2{{2.0, 3.0}, 0.5} * Pose2{{0.1 * i, 0.0}, 0.0};
    ego.update(scan);
  }
  EXPECT_NEAR((ego.pose().p_m - Eigen::Vector2d(1.0, 0.0)).norm(), 0.0, 1e-12);
}

// Of a drive at 0.1 m a scan one pose is no number, and one is where no robot gets to.
TEST(EgoMotionTest, OdometryThatCannotBeIsLeftOut) {
  for (const double fault_m : {std::numeric_limits<double>::quiet_NaN(), 1.7e308, -1.7e308, 1e5}) {
    for (const MotionSource source : {MotionSource::kOdometry, MotionSource::kAuto}) {
      EgoMotion ego(source);
      for (int i = 0; i <= 10; ++i) {
        LaserScan scan = scan_from({{0.1 * i, 0.0}, 0.0}, 0.1 * i);
        scan.X_OR = Pose2{{i == 5 ? fault_m : 0.1 * i, 0.0}, 0.0};
        ego.update(scan);
      }
      // The way to the fault and the way back from it, where it is a number.
      const double lost_m = source == MotionSource::kOdometry && std::isfinite(fault_m) ? 0.2 : 0.0;
      EXPECT_NEAR(ego.pose().p_m.x(), 1.0 - lost_m, 0.02) << fault_m;
    }
  }
}

TEST(EgoMotionTest, OdometryStandsInWhereScansSayNothing) {
  EgoMotion ego;
  for (int i = 0; i <= 10; ++i) {
    LaserScan scan = scan_from({}, 0.1 * i);
    for (double& range_m : scan.range_m) range_m = kNoEcho;
    scan.X_OR = Pose2{{0.1 * i, 0.0}, 0.0};
    ego.update(scan);
  }
  EXPECT_NEAR(ego.pose().p_m.x(), 1.0, 1e-9);
}

TEST(EgoMotionTest, OdometryThatNeverMovesIsNoOdometry) {
  EgoMotion ego;
  for (int i = 0; i <= 20; ++i) {
    LaserScan scan = scan_from(on_a_curve(0.1 * i), 0.1 * i);
    scan.X_OR = Pose2{};
    ego.update(scan);
  }
  EXPECT_NEAR((ego.pose().p_m - on_a_curve(2.0).p_m).norm(), 0.0, 0.02);
}

TEST(EgoMotionTest, StillStaysWhereItIs) {
  EgoMotion ego(MotionSource::kStill);
  for (int i = 0; i <= 10; ++i) ego.update(scan_from(on_a_curve(0.1 * i), 0.1 * i));
  EXPECT_EQ(ego.pose().p_m, Eigen::Vector2d(0.0, 0.0));
}

}  // namespace
}  // namespace scanbed
