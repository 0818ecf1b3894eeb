// SPDX-License-Identifier: MIT
#include "core/interpret/corners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/detect/feature_detector.hpp"
#include "core/geometry/angles.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

// Lines between these points, beams in their order, ends cut off by a little as measured ends are.
std::vector<Line> chain(const std::vector<Eigen::Vector2d>& corners_m, double cut_m = 0.02) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i + 1 < corners_m.size(); ++i) {
    const Eigen::Vector2d along = (corners_m[i + 1] - corners_m[i]).normalized();
    const int first = 30 * static_cast<int>(i);
    lines.push_back({.beams = {first, first + 28},
                     .left_m = corners_m[i] + cut_m * along,
                     .right_m = corners_m[i + 1] - cut_m * along,
                     .score = 0.9});
  }
  return lines;
}

Scene corners_of(const std::vector<Line>& lines) {
  Scene scene;
  find_corners(lines, {}, {}, scene);
  return scene;
}

TEST(CornersTest, TellsInnerFromOuter) {
  // A niche ahead: the wall from the right, back by half a metre, along, forward again, on to the left.
  const Scene scene = corners_of(chain({{3, -3}, {3, -1}, {3.6, -1}, {3.6, 1}, {3, 1}, {3, 3}}));
  ASSERT_EQ(scene.objects.size(), 4u);
  const bool outer[] = {true, false, false, true};
  const Eigen::Vector2d places_m[] = {{3, -1}, {3.6, -1}, {3.6, 1}, {3, 1}};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.objects[i].kind, SceneKind::kCorner);
    EXPECT_EQ(scene.objects[i].is_outer, outer[i]) << i;
    EXPECT_NEAR((scene.objects[i].center_m - places_m[i]).norm(), 0.0, 1e-9);
    ASSERT_EQ(scene.objects[i].num_from, 2);
    EXPECT_EQ(scene.from_of(scene.objects[i])[0], (FeatureRef{Primitive::kLine, i}));
    EXPECT_EQ(scene.from_of(scene.objects[i])[1], (FeatureRef{Primitive::kLine, i + 1}));
  }
}

TEST(CornersTest, MirroredScenesHaveMirroredCorners) {
  const std::vector<Eigen::Vector2d> points_m = {{3, -3}, {3, -1}, {3.6, -0.8}, {3.4, 2}};
  std::vector<Eigen::Vector2d> mirrored_m;
  for (auto p = points_m.rbegin(); p != points_m.rend(); ++p) mirrored_m.push_back({p->x(), -p->y()});
  const Scene scene = corners_of(chain(points_m));
  const Scene mirror = corners_of(chain(mirrored_m));
  ASSERT_EQ(scene.objects.size(), 2u);
  ASSERT_EQ(mirror.objects.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    const SceneObject& image = mirror.objects[1 - i];
    EXPECT_EQ(scene.objects[i].is_outer, image.is_outer);
    EXPECT_NEAR((scene.objects[i].center_m - Eigen::Vector2d(image.center_m.x(), -image.center_m.y())).norm(),
                0.0, 1e-9);
  }
}

TEST(CornersTest, AJumpIsNoCorner) {
  std::vector<Line> lines = chain({{3, -2}, {3, 0}});
  lines[0].beams = {113, 180};
  lines.push_back({.beams = {181, 189}, .left_m = {4.0, 0.0}, .right_m = {6.0, 0.5}});
  EXPECT_TRUE(corners_of(lines).objects.empty());
}

TEST(CornersTest, AStraightWallInPiecesHasNone) {
  EXPECT_TRUE(corners_of(chain({{3, -2}, {3.05, 0}, {3, 2}})).objects.empty());
}

TEST(CornersTest, BeamsOfSomethingElseBetweenThemAreNoCorner) {
  std::vector<Line> lines = chain({{3, -2}, {3, 0}, {2, 0.5}});
  lines[1].beams = {60, 90};
  EXPECT_TRUE(corners_of(lines).objects.empty());
}

TEST(CornersTest, AFullTurnClosesWhereItBegan) {
  std::vector<Line> square = chain({{2, -2}, {2, 2}, {-2, 2}, {-2, -2}, {2, -2}});
  LaserScan full_turn;
  full_turn.geometry = {.num_beams = 120, .first_rad = -kPi / 4, .step_rad = kPi / 60};
  full_turn.range_m.assign(120, 2.0);
  Scene scene;
  find_corners(square, full_turn, {}, scene);
  EXPECT_EQ(scene.objects.size(), 4u);
  EXPECT_EQ(corners_of(square).objects.size(), 3u);
}

// Beam 0 of the turn lies on the first wall: of its beams, those of the larger part are given.
TEST(CornersTest, AWallAcrossTheSeamHasItsCorners) {
  std::vector<Line> square = chain({{2, -2}, {2, 2}, {-2, 2}, {-2, -2}, {2, -2}});
  LaserScan full_turn;
  full_turn.geometry = {.num_beams = 120, .first_rad = -kPi / 4 + kPi / 6, .step_rad = kPi / 60};
  full_turn.range_m.assign(120, 2.0);
  square[0].beams = {0, 18};
  for (int i = 1; i < 4; ++i) square[i].beams = {30 * i - 10, 30 * i + 18};
  Scene scene;
  find_corners(square, full_turn, {}, scene);
  EXPECT_EQ(scene.objects.size(), 4u);
}

// Of a wall with a free end and one behind it: whatever beam the turn begins with.
TEST(CornersTest, TheSeamMakesNone) {
  for (int first_deg = -180; first_deg < 180; first_deg += 5) {
    testing::IdealScene scene({.num_beams = 360, .first_rad = radians(first_deg), .step_rad = radians(1.0)});
    scene.wall({2.08, -2.5}, {2.08, 0.0});
    scene.wall({2.34, 0.02}, {4.2, 1.69});
    const LaserScan scan = scene.scan();
    FeatureDetector detector(robust_options());
    Scene found;
    find_corners(detector.detect(scan).lines, scan, {}, found);
    EXPECT_TRUE(found.objects.empty()) << first_deg;
  }
}

TEST(CornersTest, NoLinesNoCorners) {
  EXPECT_TRUE(corners_of({}).objects.empty());
}

// A long wall that the beams graze is seen in points half a metre apart: so far may a corner be from the
// last.
TEST(CornersTest, ACornerMayLieBetweenBeamsThatAreFarApart) {
  for (const int num_beams : {181, 361}) {
    for (const auto& [half_x_m, half_y_m] : {std::pair(5.0, 2.0), {6.0, 2.0}, {8.0, 4.0}}) {
      testing::IdealScene room({.num_beams = num_beams, .step_rad = kPi / (num_beams - 1)});
      room.wall({-half_x_m, -half_y_m}, {half_x_m, -half_y_m});
      room.wall({half_x_m, -half_y_m}, {half_x_m, half_y_m});
      room.wall({half_x_m, half_y_m}, {-half_x_m, half_y_m});
      const LaserScan scan = testing::with_noise(room.scan(), 0.003, 1);
      FeatureDetector detector(robust_options());
      Scene scene;
      find_corners(detector.detect(scan).lines, scan, {}, scene);
      ASSERT_EQ(scene.objects.size(), 2u) << num_beams << " beams, " << half_x_m;
      for (const SceneObject& corner : scene.objects) {
        EXPECT_FALSE(corner.is_outer);
        EXPECT_NEAR(corner.center_m.x(), half_x_m, 0.03);
        EXPECT_NEAR(std::abs(corner.center_m.y()), half_y_m, 0.03);
      }
    }
  }
}

// The wall behind ends where the nearer one hides it, not at it.
TEST(CornersTest, WhatHidesAWallMakesNoCornerWithIt) {
  testing::IdealScene scene;
  scene.wall({4.0, -4.0}, {4.0, 1.5});
  scene.wall({2.0, 0.5}, {2.6, 2.0});
  const LaserScan scan = testing::with_noise(scene.scan(), 0.003, 1);
  FeatureDetector detector(robust_options());
  const std::vector<Line> lines = detector.detect(scan).lines;
  ASSERT_EQ(lines.size(), 2u);
  Scene found;
  find_corners(lines, scan, {}, found);
  EXPECT_TRUE(found.objects.empty());
}

}  // namespace
}  // namespace scanbed
