// SPDX-License-Identifier: MIT
#include "sim/render/scan_overlay.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

// A plan of 12 x 9 m at 640 x 480 pixels: 480 / 9 = 53.3 pixels a metre. The laser stands at (1, -2), looking
// along y: what is ahead of it lies at greater y, what is to its left at smaller x.
class ScanOverlayTest : public ::testing::Test {
 protected:
  ScanOverlayTest() {
    X_WS_.translation() = Eigen::Vector3d(1.0, -2.0, 0.28);
    X_WS_.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  static Eigen::Vector2d at_px(double x_W, double y_W) {
    const double px_per_m = 480.0 / 9.0;
    return {320.0 + px_per_m * x_W, 240.0 - px_per_m * y_W};
  }
  static Image white() { return {640, 480, std::vector<std::uint8_t>(3UL * 640 * 480, 255)}; }

  Eigen::Isometry3d X_WS_ = Eigen::Isometry3d::Identity();
  ViewCamera camera_ =
      plan_camera({Eigen::Vector3d(-6, -4.5, 0), Eigen::Vector3d(6, 4.5, 1)}, {640, 480}, {0, 0, 0});
  std::vector<float> depth_m_ = std::vector<float>(640UL * 480, 1e6F);
  Canvas canvas_{white()};
  ScenePen pen_{canvas_, camera_, depth_m_, {}};
};

bool is_blue(const Eigen::Vector3d& c) {
  return c.z() > 0.5 && c.x() < 0.4 && c.y() < 0.5;
}
bool is_white(const Eigen::Vector3d& c) {
  return c.minCoeff() > 0.999;
}

TEST_F(ScanOverlayTest, EchoesLieAtTheirRangeAndBearing) {
  LaserScan scan;
  scan.geometry = {.num_beams = 3, .first_rad = -kPi / 2, .step_rad = kPi / 2};
  scan.range_m = {2.0, 3.0, 4.0};
  draw_scan(pen_, X_WS_, scan, {.beams = false, .scale = 2.0});
  const Image image = canvas_.image();
  EXPECT_TRUE(is_blue(pixel(image, at_px(3.0, -2.0))));   // right
  EXPECT_TRUE(is_blue(pixel(image, at_px(1.0, 1.0))));    // ahead
  EXPECT_TRUE(is_blue(pixel(image, at_px(-3.0, -2.0))));  // left
  EXPECT_TRUE(is_white(pixel(image, at_px(1.0, 0.0))));
}

TEST_F(ScanOverlayTest, BeamsReachFromTheLaserToTheEcho) {
  LaserScan scan;
  scan.geometry = {.num_beams = 1, .first_rad = 0.0, .step_rad = 0.1};
  scan.range_m = {3.0};
  draw_scan(pen_, X_WS_, scan, {});
  EXPECT_TRUE(shows_near(canvas_.image(), at_px(1.0, 0.3), 1.0, [](const auto& c) { return c.x() < 0.97; }));
  EXPECT_FALSE(shows_near(canvas_.image(), at_px(1.0, 1.3), 1.0, [](const auto& c) { return !is_white(c); }));
}

TEST_F(ScanOverlayTest, BeamsWithoutEchoAndEmptyScansDrawNothing) {
  LaserScan scan;
  scan.geometry.num_beams = 0;
  draw_scan(pen_, X_WS_, scan, {});
  scan.geometry.num_beams = 3;
  scan.range_m = {kNoEcho, kTooClose, kInvalid};
  draw_scan(pen_, X_WS_, scan, {});
  EXPECT_EQ(canvas_.image().rgb, white().rgb);
}

TEST_F(ScanOverlayTest, FeaturesAreRedGreenAndPurpleWhereTheyAre) {
  Features features;
  features.lines.push_back({.left_m = {5.0, 1.0}, .right_m = {5.0, -3.0}});  // W: (0, 3) to (4, 3)
  features.circles.push_back({.center_m = {2.0, 0.0}, .radius_m = 0.5});     // W: (1, 0)
  features.legs.push_back({.middle_m = {1.0, 3.0}});                         // W: (-2, -1)
  draw_features(pen_, X_WS_, features, {});
  const Image image = canvas_.image();
  EXPECT_TRUE(is_red(pixel(image, at_px(0.1, 3.0))));
  EXPECT_TRUE(is_red(pixel(image, at_px(3.9, 3.0))));
  EXPECT_FALSE(is_red(pixel(image, at_px(4.2, 3.0))));
  for (const Eigen::Vector2d& p_W : {Eigen::Vector2d(1.5, 0), {0.5, 0}, {1, 0.5}, {1, -0.5}, {1, 0}}) {
    EXPECT_TRUE(is_green(pixel(image, at_px(p_W.x(), p_W.y())))) << p_W.transpose();
  }
  EXPECT_FALSE(is_green(pixel(image, at_px(1.25, 0.0))));
  EXPECT_TRUE(is_purple(pixel(image, at_px(-2.0, -1.0))));
}

TEST_F(ScanOverlayTest, ARibbonShowsFeaturesToAViewAlongThePlane) {
  camera_ = laser_camera(X_WS_, {0.25, 50.0}, {640, 480});
  Features features;
  features.lines.push_back({.left_m = {4.0, 1.0}, .right_m = {4.0, -1.0}});
  draw_features(pen_, X_WS_, features, {.ribbon_m = 0.5});
  // Half a metre at a depth of 4 m, where 30 degrees are 240 pixels.
  const double up_px = 240.0 / std::tan(radians(30.0)) * 0.5 / 4.0;
  EXPECT_TRUE(is_red(pixel(canvas_.image(), {320.0, 240.0 - up_px})));
  EXPECT_TRUE(is_red(pixel(canvas_.image(), {320.0, 240.0 + up_px})));
  EXPECT_FALSE(is_red(pixel(canvas_.image(), {320.0, 240.0})));
}

TEST_F(ScanOverlayTest, FeaturesThatAreNotFiniteAreLeftOut) {
  Features features;
  features.lines.push_back({.left_m = {kInvalid, 0.0}, .right_m = {1.0, 0.0}});
  features.circles.push_back({.center_m = {1.0, 0.0}, .radius_m = kNoEcho});
  features.circles.push_back({.center_m = {kNoEcho, 0.0}, .radius_m = 0.2});
  features.legs.push_back({.middle_m = {kInvalid, kInvalid}});
  draw_features(pen_, X_WS_, features, {});
  const Image image = canvas_.image();
  // The one centre that is finite may show as a dot, no more.
  EXPECT_EQ(count_pixels(image, 0, 480, is_red) + count_pixels(image, 0, 480, is_purple), 0);
  EXPECT_LT(count_pixels(image, 0, 480, is_green), 60);
}

}  // namespace
}  // namespace scanbed::sim
