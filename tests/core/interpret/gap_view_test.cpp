// SPDX-License-Identifier: MIT
#include "core/interpret/gap_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

constexpr double kWall_m = 3.0;     // from the sensor, straight ahead
constexpr BeamSpan kGap{172, 188};  // within 4 degrees of straight ahead: 0.2 m to either side

// What the gap shows where a surface stands at this depth behind the wall.
GapView view_with_surface_at(double depth_m) {
  testing::IdealScene scene;
  scene.wall({kWall_m + depth_m, -9.0}, {kWall_m + depth_m, 9.0});
  return gap_view(scene.scan(), kGap, {.normal = {1.0, 0.0}, .distance_m = kWall_m});
}

TEST(GapViewTest, TellsByDepthBehindTheWall) {
  EXPECT_EQ(view_with_surface_at(-1.0), GapView::kHidden);
  EXPECT_EQ(view_with_surface_at(0.25), GapView::kRecess);
  EXPECT_EQ(view_with_surface_at(4.0), GapView::kOpen);
  EXPECT_EQ(view_with_surface_at(0.0), GapView::kUnknown);  // that is wall
  EXPECT_EQ(view_with_surface_at(0.7), GapView::kUnknown);  // an alcove is no door
}

TEST(GapViewTest, NoEchoIsOpen) {
  EXPECT_EQ(gap_view(testing::IdealScene().scan(), kGap, {.normal = {1.0, 0.0}, .distance_m = kWall_m}),
            GapView::kOpen);
}

TEST(GapViewTest, FewBeamsSayNothing) {
  testing::IdealScene scene;
  scene.wall({kWall_m + 4.0, -9.0}, {kWall_m + 4.0, 9.0});
  const WallPlane wall{.normal = {1.0, 0.0}, .distance_m = kWall_m};
  EXPECT_EQ(gap_view(scene.scan(), {180, 181}, wall), GapView::kUnknown);
  EXPECT_EQ(gap_view(scene.scan(), {181, 180}, wall), GapView::kUnknown);
  EXPECT_EQ(gap_view(scene.scan(), {1000, 2000}, wall), GapView::kUnknown);
}

TEST(GapViewTest, ThePlanePassesThroughBothEndsAndLooksAway) {
  const Line line{.left_m = {2.0, -1.0}, .right_m = {3.0, 1.0}};
  const WallPlane plane = plane_through(line);
  EXPECT_NEAR(plane.normal.dot(line.left_m), plane.distance_m, 1e-12);
  EXPECT_NEAR(plane.normal.dot(line.right_m), plane.distance_m, 1e-12);
  EXPECT_GT(plane.distance_m, 0.0);
  EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-12);
}

TEST(GapViewTest, GoesOnBehindTheSeamOfAScanAllAround) {
  testing::IdealScene scene({.num_beams = 360, .first_rad = 0.0, .step_rad = radians(1.0)});
  scene.wall({kWall_m + 0.25, -9.0}, {kWall_m + 0.25, 9.0});
  LaserScan scan = scene.scan();
  const WallPlane wall{.normal = {1.0, 0.0}, .distance_m = kWall_m};
  EXPECT_EQ(gap_view(scan, {356, 364}, wall), GapView::kRecess);
  scan.range_m.push_back(scan.range_m[0]);  // a last beam that points where the first does
  scan.geometry.num_beams = 361;
  EXPECT_EQ(gap_view(scan, {356, 364}, wall), GapView::kRecess);
  scan.range_m.resize(350);
  scan.geometry.num_beams = 350;
  EXPECT_EQ(gap_view(scan, {348, 364}, wall), GapView::kUnknown) << "two beams";
}

}  // namespace
}  // namespace scanbed
