// SPDX-License-Identifier: MIT
#include "sim/generate/hall_outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

// Shoelace formula; positive where the corners go counter-clockwise.
double area_m2(const WallChain& chain) {
  double twice_m2 = 0.0;
  for (std::size_t i = 0; i < chain.corners_m.size(); ++i) {
    const Vector2d& a_m = chain.corners_m[i];
    const Vector2d& b_m = chain.corners_m[(i + 1) % chain.corners_m.size()];
    twice_m2 += a_m.x() * b_m.y() - a_m.y() * b_m.x();
  }
  return twice_m2 / 2;
}

// A niche each metre, half a metre wide, so deep: on a wall of 6 m at 1, 2, 3, 4 and 5 m.
WallNiches each_metre(double depth_m) {
  return {.chance = 1.0,
          .first = {1.0, 1.0},
          .next = {1.0, 1.0},
          .last_m = 0.5,
          .width = {0.5, 0.5},
          .depth = {depth_m, depth_m}};
}

TEST(HallOutlineTest, IsARectangleWithoutNiches) {
  WorldDice dice(1, "test");
  WallNiches none = each_metre(0.2);
  none.chance = 0.0;
  const WallChain chain = hall_outline({3.0, 2.0}, none, dice);
  EXPECT_TRUE(chain.closed);
  EXPECT_EQ(chain.corners_m.size(), 4u);
  EXPECT_DOUBLE_EQ(area_m2(chain), 24.0);
}

TEST(HallOutlineTest, NichesGoOutwardsAndProjectionsInwards) {
  // Walls of 6 and 4 m have 5 and 3 niches each.
  constexpr double kNicheArea_m2 = 2 * (5 + 3) * 0.5 * 0.2;
  for (const double sign : {1.0, -1.0}) {
    WorldDice dice(1, "test");
    const WallChain chain = hall_outline({3.0, 2.0}, each_metre(0.2 * sign), dice);
    EXPECT_EQ(chain.corners_m.size(), 4u + 4u * 16u);
    EXPECT_NEAR(area_m2(chain), 24.0 + sign * kNicheArea_m2, 1e-12);
  }
}

TEST(HallOutlineTest, NoNicheStandsNearTheEndOfItsWall) {
  WorldDice dice(1, "test");
  WallNiches niches = each_metre(0.2);
  niches.last_m = 3.5;
  const WallChain chain = hall_outline({3.0, 2.0}, niches, dice);
  // At 1 and 2 m of the long walls; the short ones have no place for any.
  EXPECT_EQ(chain.corners_m.size(), 4u + 4u * 4u);
}

TEST(HallOutlineTest, IsTheSameForTheSameDice) {
  const WallNiches niches{0.5, {0.3, 1.5}, {1.4, 3.0}, 1.5, {0.08, 1.2}, {-0.15, 0.35}};
  WorldDice one(7, "test"), same(7, "test"), other(8, "test");
  const auto corners_m = hall_outline({5.0, 3.0}, niches, one).corners_m;
  EXPECT_EQ(hall_outline({5.0, 3.0}, niches, same).corners_m, corners_m);
  EXPECT_NE(hall_outline({5.0, 3.0}, niches, other).corners_m, corners_m);
}

}  // namespace
}  // namespace scanbed::sim
