// SPDX-License-Identifier: MIT
#include "core/track/leg_circle.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

TEST(LegCircleTest, AThinCircleOnALegIsTheLeg) {
  const Circle circle{.beams = {99, 107}, .radius_m = 0.06};
  const std::vector<Leg> legs = {{.beams = {10, 14}, .score = 0.9}, {.beams = {107, 110}, .score = 0.7}};
  EXPECT_TRUE(is_leg_too(circle, legs));
  EXPECT_FALSE(is_leg_too({.beams = {99, 106}, .radius_m = 0.06}, legs));  // beside it
  EXPECT_FALSE(is_leg_too({.beams = {99, 107}, .radius_m = 0.25}, legs));  // a column with a leg before it
  EXPECT_FALSE(is_leg_too(circle, {{.beams = {99, 107}, .score = 0.2}}));  // hardly a leg
  EXPECT_FALSE(is_leg_too(circle, {}));
}

}  // namespace
}  // namespace scanbed
