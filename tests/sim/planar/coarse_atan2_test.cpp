// SPDX-License-Identifier: MIT
#include "sim/planar/coarse_atan2.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace scanbed::sim {
namespace {

TEST(CoarseAtan2Test, IsWithinItsErrorAllAround) {
  constexpr int kNum = 100000;
  for (int i = 0; i <= kNum; ++i) {
    const double angle_rad = -kPi + 2.0 * kPi * i / kNum;
    const double size = 0.001 + i % 17;
    const double y = size * std::sin(angle_rad);
    const double x = size * std::cos(angle_rad);
    ASSERT_LE(std::abs(coarse_atan2(y, x) - std::atan2(y, x)), kCoarseAtan2Error_rad) << angle_rad;
  }
}

TEST(CoarseAtan2Test, HasTheAxesAndTheirSides) {
  EXPECT_EQ(coarse_atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(coarse_atan2(0.0, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(coarse_atan2(3.0, 0.0), kPi / 2);
  EXPECT_DOUBLE_EQ(coarse_atan2(-3.0, 0.0), -kPi / 2);
  EXPECT_DOUBLE_EQ(coarse_atan2(0.0, -2.0), kPi);
  EXPECT_NEAR(coarse_atan2(-1e-9, -2.0), -kPi, kCoarseAtan2Error_rad);
}

}  // namespace
}  // namespace scanbed::sim
