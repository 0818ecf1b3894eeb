// SPDX-License-Identifier: MIT
#include "sim/spatial/appearance.hpp"

#include <gtest/gtest.h>

namespace scanbed::sim {
namespace {

Solid solid(const std::string& label, const SolidShape& shape) {
  return {.id = "x", .label = label, .shape = shape};
}

TEST(AppearanceTest, ColoursAreMutedSoThatFeaturesStandOut) {
  // Features are red, green and purple: in each, one channel is more than 0.4 away from another. Things stay
  // below that.
  for (const char* label : {"wall", "column", "bench", "box", "door", "trash_can", "tree", "no such label"}) {
    for (const SolidShape& shape : {SolidShape(Cylinder{}), SolidShape(Box{}), SolidShape(WallChain{})}) {
      const Rgb color = solid_color(solid(label, shape));
      EXPECT_GE(color.minCoeff(), 0.0) << label;
      EXPECT_LE(color.maxCoeff(), 1.0) << label;
      EXPECT_LT(color.maxCoeff() - color.minCoeff(), 0.4) << label;
    }
  }
}

TEST(AppearanceTest, ABenchHasASeatOfAnotherColourThanItsFeet) {
  EXPECT_NE(solid_color(solid("bench", Cylinder{})), solid_color(solid("bench", Box{})));
}

TEST(AppearanceTest, NeighbouringWalkersDressDifferently) {
  for (int i = 0; i < 12; ++i) EXPECT_NE(walker_colors(i).shirt, walker_colors(i + 1).shirt) << i;
}

}  // namespace
}  // namespace scanbed::sim
