// SPDX-License-Identifier: MIT
#include "sim/render/scene_grid.hpp"

#include <gtest/gtest.h>

#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

class SceneGridTest : public ::testing::Test {
 protected:
  static Image white() { return {640, 480, std::vector<std::uint8_t>(std::size_t{3} * 640 * 480, 255)}; }
  Eigen::Vector2d at_px(double x_m, double y_m) const { return camera_.project({x_m, y_m, 0.0})->at_px; }
  bool is_inked(double x_m, double y_m) const {
    return shows_near(canvas_.image(), at_px(x_m, y_m), 1.0, [](const auto& c) { return c.x() < 0.95; });
  }

  Eigen::AlignedBox3d bounds_{Eigen::Vector3d(-3.2, -2, 0), Eigen::Vector3d(3.2, 2, 1)};
  ViewCamera camera_ = plan_camera(bounds_, {640, 480}, {});
  Canvas canvas_{white()};
  std::vector<float> depth_m_ = std::vector<float>(640 * 480, 1e6F);
  ScenePen pen_{canvas_, camera_, depth_m_, {.hidden_ratio = 1.0}};
};

TEST_F(SceneGridTest, CartesianLinesLieOnWholeMetresAndNowhereElse) {
  draw_cartesian_grid(pen_, bounds_, 1.0);
  for (int x = -3; x <= 3; ++x) EXPECT_TRUE(is_inked(x, 0.5)) << x;
  for (int y = -2; y <= 2; ++y) EXPECT_TRUE(is_inked(0.5, y)) << y;
  for (int x = -3; x < 3; ++x) EXPECT_FALSE(is_inked(x + 0.5, 0.5)) << x;
}

TEST_F(SceneGridTest, PolarRingsAreAboutTheLaser) {
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();
  X_WS.translation() << 0.5, 0.0, 0.0;
  draw_polar_grid(pen_, X_WS, 2.0, 1.0);
  for (const double angle_rad : {0.1, 0.9, 2.0, 4.0}) {
    EXPECT_TRUE(is_inked(0.5 + std::cos(angle_rad), std::sin(angle_rad))) << angle_rad;
    EXPECT_FALSE(is_inked(0.5 + 1.5 * std::cos(angle_rad), 1.5 * std::sin(angle_rad))) << angle_rad;
  }
  EXPECT_TRUE(is_inked(0.5, 1.5));  // the ray to the left
}

TEST_F(SceneGridTest, RingsSayTheirRange) {
  label_polar_grid(canvas_, camera_, Eigen::Isometry3d::Identity(), 2.0);
  EXPECT_GT(count_pixels(canvas_.image(), 0, 480, [](const auto& c) { return c.x() < 0.7; }), 20);
}

// The plan's upper edge is where a caption goes.
TEST_F(SceneGridTest, RingsWithoutRoomSayNothing) {
  const auto is_dark = [](const auto& c) { return c.x() < 0.7; };
  const Eigen::Vector3d eye_m = camera_.X_WC.translation();
  const double top_m = eye_m.y() + 0.5 * camera_.height_px / camera_.px_per_m(eye_m.z());
  Eigen::Isometry3d X_WS(Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()));
  X_WS.translation() << 0.0, top_m - 2.15, 0.0;  // the second ring ends 0.15 m below the edge
  label_polar_grid(canvas_, camera_, X_WS, 2.0);
  EXPECT_EQ(count_pixels(canvas_.image(), 0, 24, is_dark), 0);
  EXPECT_GT(count_pixels(canvas_.image(), 24, 480, is_dark), 10);
}

TEST(RingStepTest, ThereAreAtMostEightRings) {
  for (const double reach_m : {0.5, 8.0, 8.1, 20.0, 81.0, 400.0}) {
    EXPECT_LE(reach_m / ring_step_m(reach_m), 8.0);
  }
  EXPECT_EQ(ring_step_m(8.0), 1.0);
  EXPECT_EQ(ring_step_m(8.2), 2.0);
}

}  // namespace
}  // namespace scanbed::sim
