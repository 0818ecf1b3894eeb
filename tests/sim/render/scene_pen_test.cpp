// SPDX-License-Identifier: MIT
#include "sim/render/scene_pen.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

// A camera at the origin that looks along -z; at 10 m depth one metre is 240 / (0.5 * 10) = 48 pixels. In the
// left half of the picture something stands 5 m away, in the right half 20 m.
class ScenePenTest : public ::testing::Test {
 protected:
  ScenePenTest() {
    for (int row = 0; row < camera_.height_px; ++row) {
      for (int column = 0; column < camera_.width_px; ++column) {
        depth_m_.push_back(column < camera_.width_px / 2 ? 5.0F : 20.0F);
      }
    }
  }
  static Eigen::Vector3d at(double x_m, double y_m) { return {x_m, y_m, -10.0}; }
  static Image white() { return {640, 480, std::vector<std::uint8_t>(3UL * 640 * 480, 255)}; }

  ViewCamera camera_;
  std::vector<float> depth_m_;
  Canvas canvas_{white()};
  const Rgba red_{1.0, 0.0, 0.0, 1.0};
};

TEST_F(ScenePenTest, WhatIsHiddenIsFainter) {
  ScenePen pen(canvas_, camera_, depth_m_, {.hidden_ratio = 0.25});
  pen.stroke({at(-3, 1), at(3, 1)}, {red_, 4.0});
  const Image image = canvas_.image();
  EXPECT_EQ(pixel(image, {320.0 + 2 * 48.0, 240.0 - 48.0}), Eigen::Vector3d(1, 0, 0));
  // A quarter of red over white.
  EXPECT_NEAR(pixel(image, {320.0 - 2 * 48.0, 240.0 - 48.0}).y(), 0.75, 0.01);
}

TEST_F(ScenePenTest, ARatioOfOneIgnoresWhatStandsInFront) {
  ScenePen pen(canvas_, camera_, depth_m_, {.hidden_ratio = 1.0});
  pen.stroke({at(-3, 1), at(3, 1)}, {red_, 4.0});
  EXPECT_EQ(pixel(canvas_.image(), {320.0 - 2 * 48.0, 240.0 - 48.0}), Eigen::Vector3d(1, 0, 0));
}

TEST_F(ScenePenTest, CornersOfAPolylineStayCorners) {
  ScenePen pen(canvas_, camera_, depth_m_, {});
  pen.stroke({at(1, 0), at(3, 0), at(3, 2)}, {red_, 4.0});
  const Image image = canvas_.image();
  EXPECT_TRUE(is_red(pixel(image, {320.0 + 2 * 48.0, 240.0})));
  EXPECT_TRUE(is_red(pixel(image, {320.0 + 3 * 48.0, 240.0})));
  EXPECT_TRUE(is_red(pixel(image, {320.0 + 3 * 48.0, 240.0 - 48.0})));
  EXPECT_FALSE(is_red(pixel(image, {320.0 + 2 * 48.0, 240.0 - 48.0})));  // on the straight way back
}

TEST_F(ScenePenTest, SeparateLinesAreNotJoined) {
  ScenePen pen(canvas_, camera_, depth_m_, {});
  pen.stroke_all({{at(1, 1), at(2, 1)}, {at(3, 1), at(4, 1)}}, {red_, 4.0});
  EXPECT_TRUE(is_red(pixel(canvas_.image(), {320.0 + 1.5 * 48.0, 240.0 - 48.0})));
  EXPECT_FALSE(is_red(pixel(canvas_.image(), {320.0 + 2.5 * 48.0, 240.0 - 48.0})));
}

TEST_F(ScenePenTest, DotsFollowTheSameRules) {
  ScenePen pen(canvas_, camera_, depth_m_, {.hidden_ratio = 0.25});
  pen.dots({at(-2, 0), at(2, 0), {0.0, 0.0, 1.0}}, 4.0, red_);
  EXPECT_EQ(pixel(canvas_.image(), {320.0 + 96.0, 240.0}), Eigen::Vector3d(1, 0, 0));
  EXPECT_NEAR(pixel(canvas_.image(), {320.0 - 96.0, 240.0}).y(), 0.75, 0.01);
}

TEST_F(ScenePenTest, LinesThroughTheCameraAndFarOutAreCut) {
  ScenePen pen(canvas_, camera_, depth_m_, {});
  pen.stroke({{0.5, -1.0, 5.0}, {0.5, -1.0, -10.0}}, {red_, 4.0});
  pen.stroke({at(1, 2), at(1e7, 2)}, {red_, 4.0});
  pen.stroke({}, {red_, 4.0});
  pen.stroke({at(1, 1)}, {red_, 4.0});
  EXPECT_TRUE(is_red(pixel(canvas_.image(), {320.0 + 24.0, 240.0 + 48.0})));
  EXPECT_TRUE(is_red(pixel(canvas_.image(), {600.0, 240.0 - 96.0})));
  EXPECT_FALSE(is_red(pixel(canvas_.image(), {320.0 + 48.0, 240.0 - 48.0})));
}

}  // namespace
}  // namespace scanbed::sim
