// SPDX-License-Identifier: MIT
#include "sim/render/truth_overlay.hpp"

#include <gtest/gtest.h>

#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

bool is_truth(const Eigen::Vector3d& c) {
  return c.z() > c.x() + 0.2 && c.x() < 0.5;
}

ObjectTruth seen(const std::string& id, Primitive primitive) {
  ObjectTruth object;
  object.id = id;
  object.primitive = primitive;
  object.num_clean_beams = 5;
  return object;
}

class TruthOverlayTest : public ::testing::Test {
 protected:
  static Image white() { return {640, 480, std::vector<std::uint8_t>(std::size_t{3} * 640 * 480, 255)}; }
  bool shows(double x_m, double y_m) const {
    return shows_near(canvas_.image(), camera_.project({x_m, y_m, 0.0})->at_px, 1.0, is_truth);
  }

  Eigen::AlignedBox3d bounds_{Eigen::Vector3d(-3.2, -2, 0), Eigen::Vector3d(3.2, 2, 1)};
  ViewCamera camera_ = plan_camera(bounds_, {640, 480}, {});
  Canvas canvas_{white()};
  std::vector<float> depth_m_ = std::vector<float>(640 * 480, 1e6F);
  ScenePen pen_{canvas_, camera_, depth_m_, {.hidden_ratio = 1.0}};
  Eigen::Isometry3d X_WS_ = Eigen::Isometry3d::Identity();
};

TEST_F(TruthOverlayTest, WallsAreLinesAndColumnsRings) {
  Truth truth;
  truth.objects = {seen("wall", Primitive::kLine), seen("column", Primitive::kCircle)};
  truth.objects[0].from_m = {-2, 1};
  truth.objects[0].to_m = {2, 1};
  truth.objects[1].center_m = {1, -1};
  truth.objects[1].radius_m = 0.5;
  draw_truth(pen_, X_WS_, truth, 1.0);
  EXPECT_TRUE(shows(0, 1));
  EXPECT_FALSE(shows(2.3, 1));
  EXPECT_TRUE(shows(1.5, -1));
  EXPECT_TRUE(shows(1, -0.5));
  EXPECT_FALSE(shows(1, -1));
}

TEST_F(TruthOverlayTest, WhatNoBeamMetIsLeftOut) {
  Truth truth;
  truth.objects = {seen("hidden", Primitive::kCircle), seen("floor", Primitive::kNone)};
  truth.objects[0].num_clean_beams = 0;
  truth.objects[0].radius_m = truth.objects[1].radius_m = 0.5;
  draw_truth(pen_, X_WS_, truth, 1.0);
  draw_labels(canvas_, camera_, X_WS_, truth);
  EXPECT_EQ(canvas_.image().rgb, white().rgb);
}

TEST_F(TruthOverlayTest, LabelsStandAboveTheirObjects) {
  Truth truth;
  truth.objects = {seen("column", Primitive::kCircle)};
  truth.objects[0].center_m = {1, 0};
  draw_labels(canvas_, camera_, X_WS_, truth);
  const int row = static_cast<int>(camera_.project({1, 0, 0})->at_px.y());
  EXPECT_GT(count_pixels(canvas_.image(), row - 25, row, is_truth), 20);
  EXPECT_EQ(count_pixels(canvas_.image(), row, 480, is_truth), 0);
}

}  // namespace
}  // namespace scanbed::sim
