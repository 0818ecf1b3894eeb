// SPDX-License-Identifier: MIT
#include "sim/world/solid_geometry.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kGeometryRounding = 1e-12;

TEST(SolidGeometryTest, AClosedChainHasAnEdgeMore) {
  WallChain chain{.corners_m = {{0, 0}, {2, 0}, {2, 1}}, .closed = false};
  EXPECT_EQ(outline(chain).size(), 2U);
  chain.closed = true;
  const std::vector<Edge> edges = outline(chain);
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[2].a_m, Vector2d(2, 1));
  EXPECT_EQ(edges[2].b_m, Vector2d(0, 0));
}

TEST(SolidGeometryTest, ABoxHasFourEdgesRoundItsCentre) {
  const std::vector<Edge> edges = outline(Box{.X_WB = {{3, 4}, kPi / 2}, .size_m = {2, 1}});
  ASSERT_EQ(edges.size(), 4U);
  EXPECT_NEAR((edges[0].a_m - Vector2d(3.5, 3)).norm(), 0.0, kGeometryRounding);
  EXPECT_NEAR((edges[0].b_m - Vector2d(3.5, 5)).norm(), 0.0, kGeometryRounding);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(edges[i].b_m, edges[(i + 1) % 4].a_m);
}

TEST(SolidGeometryTest, ACylinderHasNoEdges) {
  EXPECT_TRUE(outline(Cylinder{}).empty());
}

TEST(SolidGeometryTest, DistanceToAnEdgeIsToItsNearestPoint) {
  const Edge edge{{0, 0}, {2, 0}};
  EXPECT_DOUBLE_EQ(distance_m(edge, {1, 3}), 3.0);
  EXPECT_DOUBLE_EQ(distance_m(edge, {5, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance_m(edge, {-3, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance_m(edge, {1, 0}), 0.0);
  EXPECT_DOUBLE_EQ(distance_m({{1, 1}, {1, 1}}, {4, 5}), 5.0);
}

TEST(SolidGeometryTest, AWayCrossesAnEdgeThatItCutsInside) {
  const Edge edge{{0, 0}, {2, 0}};
  EXPECT_TRUE(crosses(edge, {1, -1}, {1.5, 1}));
  EXPECT_TRUE(crosses(edge, {1.5, 1}, {1, -1}));
  EXPECT_FALSE(crosses(edge, {3, -1}, {3, 1}));
  EXPECT_FALSE(crosses(edge, {1, 1}, {1, 2}));
  EXPECT_FALSE(crosses(edge, {1, 1}, {1, 0}));
  EXPECT_FALSE(crosses(edge, {-1, 0}, {3, 0}));
  EXPECT_FALSE(crosses({{1, 0}, {1, 0}}, {1, -1}, {1, 1}));
}

TEST(SolidGeometryTest, ClearanceIsNegativeInsideWhatHasAnInside) {
  EXPECT_DOUBLE_EQ(clearance_m(Cylinder{{1, 0}, 0.5}, {1, 0}), -0.5);
  EXPECT_DOUBLE_EQ(clearance_m(Cylinder{{1, 0}, 0.5}, {3, 0}), 1.5);
  const Box box{.X_WB = {{0, 0}, 0.0}, .size_m = {4, 2}};
  EXPECT_NEAR(clearance_m(box, {0, 0}), -1.0, kGeometryRounding);
  EXPECT_NEAR(clearance_m(box, {5, 5}), 5.0, kGeometryRounding);
  const Polygon triangle{.corners_m = {{0, 0}, {3, 0}, {0, 3}}};
  EXPECT_NEAR(clearance_m(triangle, {1, 0.5}), -0.5, kGeometryRounding);
  EXPECT_NEAR(clearance_m(triangle, {3, 3}), std::sqrt(4.5), kGeometryRounding);
  const WallChain room{.corners_m = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, .closed = true};
  EXPECT_NEAR(clearance_m(room, {1, 0.75}), 0.75, kGeometryRounding);
}

TEST(SolidGeometryTest, ASolidReachesFromItsBottomToItsTop) {
  Solid seat;
  seat.bottom_m = 0.4;
  seat.top_m = 0.45;
  EXPECT_FALSE(is_at_height(seat, 0.28));
  EXPECT_TRUE(is_at_height(seat, 0.4));
  EXPECT_TRUE(is_at_height(seat, 0.45));
  EXPECT_FALSE(is_at_height(seat, 0.46));
}

}  // namespace
}  // namespace scanbed::sim
