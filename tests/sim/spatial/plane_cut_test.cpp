// SPDX-License-Identifier: MIT
#include "sim/spatial/plane_cut.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"
#include "sim/planar/ray_caster.hpp"

namespace scanbed::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector2d;
using Eigen::Vector3d;

LaserPlane pitched(double height_m, double pitch_rad) {
  return {{0, 0, height_m}, AngleAxisd(pitch_rad, Vector3d::UnitY()).toRotationMatrix()};
}

double range_ahead_m(const PlanarSlice& slice) {
  ScanGeometry geometry;
  geometry.num_beams = 1;
  geometry.first_rad = 0.0;
  RayCaster caster(geometry);
  caster.cast(slice, {});
  return caster.range_m(0);
}

const Polyhedron kBlock = prism({{2, -1}, {4, -1}, {4, 1}, {2, 1}}, 0.0, 1.0, {0, 1, 2, 3, 4});

TEST(PlaneCutTest, AnUprightLaserCutsABlockInItsPlan) {
  PlanarSlice slice;
  PlaneCutter().cut(pitched(0.5, 0.0), kBlock, slice);
  ASSERT_EQ(slice.segments.size(), 4U);
  for (const SliceSegment& s : slice.segments) {
    EXPECT_LT(s.object, 4);
    EXPECT_EQ(s.steepness_ratio, 1.0);
  }
  EXPECT_EQ(range_ahead_m(slice), 2.0);
}

TEST(PlaneCutTest, NeighbouringFacesShareTheirCornersToTheBit) {
  PlanarSlice slice;
  PlaneCutter().cut(pitched(0.9, 0.123), kBlock, slice);
  ASSERT_GE(slice.segments.size(), 3U);
  for (const SliceSegment& s : slice.segments) {
    for (const Vector2d& corner : {s.a_m, s.b_m}) {
      const auto num_there = std::count_if(slice.segments.begin(), slice.segments.end(),
                                           [&](const auto& o) { return o.a_m == corner || o.b_m == corner; });
      EXPECT_EQ(num_there, 2);
    }
  }
}

TEST(PlaneCutTest, ALaserAboveABlockThatLooksDownMeetsItsTop) {
  PlanarSlice slice;
  const double pitch_rad = std::atan2(1.0, 3.0);  // from 2 m height down to the top at x = 3
  PlaneCutter().cut(pitched(2.0, pitch_rad), kBlock, slice);
  EXPECT_NEAR(range_ahead_m(slice), std::hypot(1.0, 3.0), 1e-12);
  const auto top = std::find_if(slice.segments.begin(), slice.segments.end(),
                                [](const SliceSegment& s) { return s.object == 4; });
  ASSERT_NE(top, slice.segments.end());
  EXPECT_NEAR(top->steepness_ratio, std::sin(pitch_rad), 1e-12);
}

TEST(PlaneCutTest, ABlockAboveOrBelowIsNotCut) {
  PlanarSlice slice;
  PlaneCutter().cut(pitched(1.5, 0.0), kBlock, slice);
  PlaneCutter().cut(pitched(-0.5, 0.0), kBlock, slice);
  EXPECT_TRUE(slice.segments.empty());
}

// A laser at height h meets a solid if bottom_m <= h <= top_m (sim/world/world.hpp).
TEST(PlaneCutTest, ABlockIsCutAtItsBottomAndAtItsTop) {
  for (const double height_m : {0.0, 1.0}) {
    PlanarSlice slice;
    PlaneCutter().cut(pitched(height_m, 0.0), kBlock, slice);
    EXPECT_EQ(slice.segments.size(), 4U) << height_m;
    EXPECT_EQ(range_ahead_m(slice), 2.0) << height_m;
  }
}

TEST(PlaneCutTest, ASheetIsCutAtItsBottomAndAtItsTop) {
  for (const double height_m : {0.3, 1.0}) {
    PlanarSlice slice;
    PlaneCutter().cut(pitched(height_m, 0.0), sheet({Vector2d(3, -1), Vector2d(3, 1)}, 0.3, 1.0, 5), slice);
    EXPECT_EQ(range_ahead_m(slice), 3.0) << height_m;
  }
}

TEST(PlaneCutTest, ASheetIsOneSegment) {
  PlanarSlice slice;
  PlaneCutter().cut(pitched(0.5, 0.0), sheet({Vector2d(3, -1), Vector2d(3, 1)}, 0.0, 1.0, 5), slice);
  ASSERT_EQ(slice.segments.size(), 1U);
  EXPECT_EQ(slice.segments[0].object, 5);
  EXPECT_NEAR((slice.segments[0].a_m - slice.segments[0].b_m).norm(), 2.0, 1e-12);
}

// The plane at pitch p meets an upright wall at distance d after d / cos(p).
TEST(PlaneCutTest, APitchedLaserMeetsAWallFartherAway) {
  PlanarSlice slice;
  PlaneCutter().cut(pitched(0.5, 0.1), sheet({Vector2d(3, -1), Vector2d(3, 1)}, 0.0, 1.0, 5), slice);
  EXPECT_NEAR(range_ahead_m(slice), 3.0 / std::cos(0.1), 1e-12);
  EXPECT_NEAR(slice.segments[0].steepness_ratio, std::cos(0.1), 1e-12);
}

TEST(PlaneCutTest, AnUprightColumnIsADisc) {
  PlanarSlice slice;
  cut_cylinder(pitched(0.5, 0.0), {{3, 0, 1}, Vector3d::UnitZ(), 0.25, 1.0}, {1, 2}, slice);
  ASSERT_EQ(slice.discs.size(), 1U);
  EXPECT_EQ(slice.discs[0].center_m, Vector2d(3, 0));
  EXPECT_EQ(slice.discs[0].radius_m, 0.25);
  EXPECT_EQ(slice.discs[0].object, 1);
  EXPECT_TRUE(slice.segments.empty());
  cut_cylinder(pitched(2.5, 0.0), {{3, 0, 1}, Vector3d::UnitZ(), 0.25, 1.0}, {1, 2}, slice);
  EXPECT_EQ(slice.discs.size(), 1U);
}

TEST(PlaneCutTest, APitchedLaserMeetsAColumnAtItsSideOrOnItsTop) {
  const RoundBody column{{3, 0, 0.5}, Vector3d::UnitZ(), 0.25, 0.5};
  PlanarSlice side;
  cut_cylinder(pitched(0.5, 0.1), column, {1, 2}, side);
  EXPECT_NEAR(range_ahead_m(side), 2.75 / std::cos(0.1), 1e-12);
  PlanarSlice top;
  const double pitch_rad = std::atan2(1.0, 3.0);
  cut_cylinder(pitched(2.0, pitch_rad), column, {1, 2}, top);
  EXPECT_NEAR(range_ahead_m(top), std::hypot(1.0, 3.0), 1e-12);
  ASSERT_EQ(top.segments.size(), 1U);
  EXPECT_EQ(top.segments[0].object, 2);
  EXPECT_NEAR((top.segments[0].a_m - top.segments[0].b_m).norm(), 0.5, 1e-12);  // through the middle
}

// An ellipse r wide and r / cos(lean) long: what a shank that leans by 0.3 rad is cut to.
TEST(PlaneCutTest, ALeaningCapsuleIsAnEllipseAboutItsAxis) {
  PlanarSlice slice;
  const Vector3d axis(std::sin(0.3), 0, std::cos(0.3));
  cut_capsule(pitched(0.5, 0.0), {Vector3d(3, 0, 0.5) + 0.1 * axis, axis, 0.06, 0.4}, 4, slice);
  ASSERT_EQ(slice.arcs.size(), 1U);
  EXPECT_NEAR((slice.arcs[0].center_m - Vector2d(3, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(range_ahead_m(slice), 3.0 - 0.06 / std::cos(0.3), 1e-12);
}

TEST(PlaneCutTest, ACapsulesRoundEndReachesFartherThanItsCylinder) {
  PlanarSlice slice;
  cut_capsule(pitched(1.0, 0.0), {{3, 0, 0.5}, Vector3d::UnitZ(), 0.1, 0.45}, 4, slice);
  // The ball about (3, 0, 0.95), cut 0.05 m above its centre.
  EXPECT_NEAR(range_ahead_m(slice), 3.0 - std::sqrt(0.1 * 0.1 - 0.05 * 0.05), 1e-12);
}

TEST(PlaneCutTest, AnEllipsoidIsCutInAnEllipse) {
  PlanarSlice slice;
  cut_ellipsoid(pitched(1.0, 0.0), {{3, 0, 1.15}, Eigen::Matrix3d::Identity(), {0.2, 0.1, 0.3}}, 4, slice);
  // At half its height: sqrt(3)/2 of its widest.
  EXPECT_NEAR(range_ahead_m(slice), 3.0 - 0.2 * std::sqrt(0.75), 1e-12);
}

TEST(PlaneCutTest, TheFloorIsMetWhereALaserLooksDown) {
  PlanarSlice level;
  cut_floor(pitched(0.28, 0.0), 9, level);
  EXPECT_TRUE(level.segments.empty());
  PlanarSlice down;
  cut_floor(pitched(0.28, 0.1), 9, down);
  EXPECT_NEAR(range_ahead_m(down), 0.28 / std::sin(0.1), 1e-9);
  PlanarSlice up;
  cut_floor(pitched(0.28, -0.1), 9, up);
  EXPECT_EQ(range_ahead_m(up), std::numeric_limits<double>::infinity());  // it is behind
}

}  // namespace
}  // namespace scanbed::sim
