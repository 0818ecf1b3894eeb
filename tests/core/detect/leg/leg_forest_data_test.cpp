// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/detect/leg/leg_forest.hpp"

namespace scanbed {
namespace {

TEST(LegForestDataTest, EveryTreeAsksFeaturesThatThereAre) {
  const LegForest& forest = trained_leg_forest();
  ASSERT_GE(forest.trees.size(), 50u);
  for (const LegTree& tree : forest.trees) {
    for (const std::uint8_t feature : tree.feature) EXPECT_LT(feature, kNumLegFeatures);
    for (const float threshold : tree.threshold) EXPECT_TRUE(std::isfinite(threshold));
    for (const float value : tree.value) EXPECT_LE(std::abs(value), 4.0F);
  }
}

TEST(LegForestDataTest, TheFirstTreesAskNothingOfPartners) {
  const LegForest& forest = trained_leg_forest();
  ASSERT_GT(forest.num_alone, 0);
  for (const LegTree& tree : forest.trees.first(forest.num_alone)) {
    for (const std::uint8_t feature : tree.feature) EXPECT_LT(feature, kNumOwnLegFeatures);
  }
}

TEST(LegForestDataTest, CheckpointsRiseWithinTheForest) {
  const LegForest& forest = trained_leg_forest();
  int before = forest.num_alone - 1;
  for (const LegForest::Checkpoint& checkpoint : forest.checkpoints) {
    EXPECT_GT(checkpoint.num_trees, before);
    before = checkpoint.num_trees;
  }
  EXPECT_LE(before, static_cast<int>(forest.trees.size()));
}

TEST(LegForestDataTest, AGreaterSumIsALikelierLeg) {
  EXPECT_GT(trained_leg_forest().slope, 0.0);
}

}  // namespace
}  // namespace scanbed
