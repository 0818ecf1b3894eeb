// SPDX-License-Identifier: MIT
#include "sim/render/view_camera.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "core/geometry/angles.hpp"

namespace scanbed::sim {
namespace {

Eigen::AlignedBox3d box(const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
  return {least, most};
}

TEST(ViewCameraTest, ProjectsAsAPinhole) {
  // Looks along -z from (1, 2, 10); half the height is tan 0.5 of the depth.
  ViewCamera camera;
  camera.X_WC.translation() = Eigen::Vector3d(1, 2, 10);
  const auto at = camera.project({2.0, 3.0, 6.0});
  ASSERT_TRUE(at);
  EXPECT_DOUBLE_EQ(at->depth_m, 4.0);
  // One metre is 240 / (0.5 * 4) = 120 pixels.
  EXPECT_NEAR(at->at_px.x(), 320.0 + 120.0, 1e-9);
  EXPECT_NEAR(at->at_px.y(), 240.0 - 120.0, 1e-9);
}

TEST(ViewCameraTest, WhatIsBehindHasNoPlaceInThePicture) {
  ViewCamera camera;
  EXPECT_FALSE(camera.project({0.0, 0.0, 1.0}));
  EXPECT_FALSE(camera.project({0.0, 0.0, -0.05}));
  EXPECT_TRUE(camera.project({0.0, 0.0, -0.2}));
}

TEST(ViewCameraTest, ThePlanIsAScaleDrawing) {
  const FrameMargins margins{.top_ratio = 0.1, .bottom_ratio = 0.1, .side_ratio = 0.1};
  const ViewCamera camera = plan_camera(box({-7, 0, 0}, {7, 9, 2.5}), {960, 720}, margins);
  // 960 - 2 * 72 = 816 pixels for 14 m, 720 - 2 * 72 = 576 for 9 m: the width decides.
  const double px_per_m = 816.0 / 14.0;
  for (const double z_m : {0.0, 0.28, 2.5}) {
    const auto at = camera.project({3.0, 8.0, z_m});
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->at_px.x(), 480.0 + 3.0 * px_per_m, 0.25) << z_m;
    EXPECT_NEAR(at->at_px.y(), 360.0 - 3.5 * px_per_m, 0.25) << z_m;
  }
}

TEST(ViewCameraTest, ThePlanLeavesUnequalMarginsFree) {
  const FrameMargins margins{.top_ratio = 0.05, .bottom_ratio = 0.25, .side_ratio = 0.0};
  const ViewCamera camera = plan_camera(box({0, 0, 0}, {1, 10, 1}), {800, 1000}, margins);
  EXPECT_NEAR(camera.project({0.5, 10.0, 1.0})->at_px.y(), 50.0, 0.5);
  EXPECT_NEAR(camera.project({0.5, 0.0, 1.0})->at_px.y(), 750.0, 0.5);
  EXPECT_NEAR(camera.project({0.5, 5.0, 1.0})->at_px.x(), 400.0, 1e-6);
}

TEST(ViewCameraTest, TheLasersEyeSeesBearingsAsTangents) {
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();
  X_WS.translation() = Eigen::Vector3d(1, 2, 0.28);
  X_WS.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const ViewCamera camera = laser_camera(X_WS, {0.25, 50.0}, {640, 480});
  const double bearing_rad = radians(20.0);
  const auto at =
      camera.project(X_WS * Eigen::Vector3d(3 * std::cos(bearing_rad), 3 * std::sin(bearing_rad), 0.0));
  ASSERT_TRUE(at);
  // 30 degrees up is the picture's upper edge; positive bearings are to the left.
  EXPECT_NEAR(at->at_px.x(), 320.0 - 240.0 * std::tan(bearing_rad) / std::tan(radians(30.0)), 1e-9);
  EXPECT_NEAR(at->at_px.y(), 240.0, 1e-9);
}

double between(int low, int high) {
  return 0.01 * *rc::gen::inRange(100 * low, 100 * high);
}

TEST(ViewCameraTest, TheWholeBoxIsInsideTheMarginsAndTouchesThem) {
  rc::check([] {
    const Eigen::Vector3d least(between(-50, 50), between(-50, 50), 0.0);
    const Eigen::AlignedBox3d bounds =
        box(least, least + Eigen::Vector3d(between(2, 60), between(2, 60), between(1, 4)));
    const PictureSize size{*rc::gen::inRange(200, 1200), *rc::gen::inRange(200, 1200)};
    const FrameMargins margins;
    const ViewCamera camera = *rc::gen::element(plan_camera(bounds, size, margins),
                                                oblique_camera(bounds, between(-4, 4), size, margins));
    Eigen::AlignedBox2d seen;
    for (int i = 0; i < 8; ++i) {
      const auto at = camera.project(bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
      RC_ASSERT(at.has_value());
      RC_ASSERT(at->depth_m < camera.far_m);
      seen.extend(at->at_px);
    }
    const double side_px = std::min(margins.side_ratio * size.height_px, 0.4 * size.width_px);
    const double left_px = seen.min().x() - side_px;
    const double right_px = size.width_px - side_px - seen.max().x();
    const double top_px = seen.min().y() - margins.top_ratio * size.height_px;
    const double bottom_px = (1.0 - margins.bottom_ratio) * size.height_px - seen.max().y();
    for (const double gap_px : {left_px, right_px, top_px, bottom_px}) RC_ASSERT(gap_px > -1e-6);
    // One pair of opposite margins is touched on both sides.
    RC_ASSERT(std::min(left_px + right_px, top_px + bottom_px) < 1e-3);
  });
}

}  // namespace
}  // namespace scanbed::sim
