// SPDX-License-Identifier: MIT
#include "sim/world/furniture.hpp"

#include <gtest/gtest.h>

#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

const Box& box_of(const Solid& solid) {
  return std::get<Box>(solid.shape);
}

TEST(FurnitureTest, ABenchIsASeatAcrossTwoFeet) {
  const std::vector<Solid> parts =
      bench_parts({.id = "b", .X_WB = {{1.0, 2.0}, kPi / 2}, .foot_radius_m = 0.2, .feet_apart_m = 1.0});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_TRUE(std::get<Cylinder>(parts[0].shape).center_m.isApprox(Vector2d(1.0, 1.5), 1e-12));
  EXPECT_TRUE(std::get<Cylinder>(parts[1].shape).center_m.isApprox(Vector2d(1.0, 2.5), 1e-12));
  EXPECT_EQ(parts[2].id, "b.seat");
  EXPECT_EQ(parts[2].bottom_m, parts[0].top_m);
  EXPECT_TRUE(box_of(parts[2]).size_m.isApprox(Vector2d(1.4, 0.4), 1e-12));
}

TEST(FurnitureTest, AChairsLegsStandBelowTheCornersOfItsSeat) {
  const Chair chair{.id = "c", .X_WC = {{1.0, 2.0}, 0.3}, .size_m = 0.5, .leg_m = 0.04};
  const std::vector<Solid> parts = chair_parts(chair);
  ASSERT_EQ(parts.size(), 5u);
  // Corner to corner: each leg's outer corner is a corner of the seat.
  const std::vector<Edge> seat = outline(parts[4].shape);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(parts[i].id, "c.leg_" + std::to_string(i));
    EXPECT_EQ(parts[i].top_m, parts[4].bottom_m);
    EXPECT_TRUE(outline(parts[i].shape)[i].a_m.isApprox(seat[i].a_m, 1e-12)) << i;
  }
}

TEST(FurnitureTest, FitsIntoAWorld) {
  World world;
  world.robot.X_WR = {{0.0, -3.0}, 0.0};
  world.solids = chair_parts({.id = "c"});
  for (Solid& part : bench_parts({.id = "b", .X_WB = {{3.0, 0.0}, 0.0}})) world.solids.push_back(part);
  EXPECT_NO_THROW(world.validate());
}

}  // namespace
}  // namespace scanbed::sim
