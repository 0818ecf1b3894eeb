// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_forest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace scanbed {
namespace {

std::vector<LegTree> random_trees(int count, unsigned seed) {
  std::mt19937 dice(seed);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  std::vector<LegTree> trees(count);
  for (LegTree& tree : trees) {
    for (auto& feature : tree.feature) feature = static_cast<std::uint8_t>(dice() % kNumLegFeatures);
    for (float& threshold : tree.threshold) threshold = unit(dice);
    for (float& value : tree.value) value = unit(dice);
  }
  return trees;
}

LegFeatureTable random_table(int num_candidates, unsigned seed) {
  std::mt19937 dice(seed);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  LegFeatureTable table;
  table.resize(num_candidates);
  for (int f = 0; f < kNumLegFeatures; ++f) {
    for (int c = 0; c < num_candidates; ++c) table.at(f, c) = unit(dice);
  }
  return table;
}

// One question after the other.
double walk(const LegTree& tree, const LegFeatureTable& table, int candidate) {
  int leaf = 0;
  for (int level = 0; level < LegTree::kDepth; ++level) {
    if (table.at(tree.feature[level], candidate) > tree.threshold[level]) leaf += 1 << level;
  }
  return static_cast<double>(tree.value[leaf]);
}

TEST(LegForestTest, AddsUpWhatEachTreeSays) {
  const std::vector<LegTree> trees = random_trees(40, 1);
  for (const int num_candidates : {0, 1, 7, 8, 9, 50}) {
    const LegFeatureTable table = random_table(num_candidates, 2);
    std::vector<float> scores;
    LegForestScorer().score({.trees = trees}, table, {}, scores);
    ASSERT_EQ(static_cast<int>(scores.size()), num_candidates);
    for (int c = 0; c < num_candidates; ++c) {
      double expected = 0.0;
      for (const LegTree& tree : trees) expected += walk(tree, table, c);
      EXPECT_NEAR(static_cast<double>(scores[c]), expected, 1e-4);
    }
  }
}

TEST(LegForestTest, GivesUpWhatFallsBelowACheckpointAndNothingElse) {
  const std::vector<LegTree> trees = random_trees(40, 3);
  const LegForest::Checkpoint checkpoints[] = {{10, -0.5F}, {25, 0.0F}};
  const LegFeatureTable table = random_table(60, 4);
  std::vector<float> scores;
  LegForestScorer().score({.trees = trees, .checkpoints = checkpoints}, table, {}, scores);
  int num_given_up = 0;
  for (int c = 0; c < 60; ++c) {
    double sum = 0.0;
    bool stays = true;
    for (int t = 0; t < 40; ++t) {
      if ((t == 10 && sum < -0.5) || (t == 25 && sum < 0.0)) stays = false;
      sum += walk(trees[t], table, c);
    }
    if (stays) {
      EXPECT_NEAR(static_cast<double>(scores[c]), sum, 1e-4);
    } else {
      EXPECT_EQ(scores[c], LegForestScorer::kGivenUp);
      ++num_given_up;
    }
  }
  EXPECT_GT(num_given_up, 10);
  EXPECT_LT(num_given_up, 50);
}

TEST(LegForestTest, LaterTreesAskWhatTheFirstThinkOfPartners) {
  constexpr float kNever = 1e9F;
  std::vector<LegTree> trees(2);
  for (LegTree& tree : trees) {
    tree.threshold.fill(kNever);
    tree.threshold[0] = 0.0F;
  }
  // A candidate by itself is a leg if its first feature is positive, ...
  trees[0].value = {-1.0F, 1.0F};
  // ... and more so if there is another one.
  trees[1].feature[0] = static_cast<std::uint8_t>(LegFeature::kPartner35);
  trees[1].value = {0.0F, 10.0F};
  LegFeatureTable table;
  table.resize(3);
  for (int c = 0; c < 3; ++c) table.at(0, c) = c == 1 ? -1.0F : 1.0F;
  const LegPlace places[] = {{{10, 15}, 2.0F, 0.0F}, {{17, 20}, 2.0F, 0.2F}, {{30, 35}, 4.0F, 3.0F}};
  std::vector<float> scores;
  LegForestScorer().score({.trees = trees, .num_alone = 1}, table, places, scores);
  EXPECT_EQ(scores, (std::vector<float>{1.0F, 9.0F, 1.0F}));
}

TEST(LegForestTest, EveryInstructionSetGivesTheSameBits) {
  const std::vector<LegTree> trees = random_trees(50, 8);
  const LegForest::Checkpoint checkpoints[] = {{10, -0.5F}, {25, 0.0F}};
  const LegForest forest{.trees = trees, .checkpoints = checkpoints};
  LegFeatureTable table = random_table(61, 9);
  table.at(trees[0].feature[0], 3) = std::numeric_limits<float>::quiet_NaN();
  table.at(trees[0].feature[0], 4) = trees[0].threshold[0];  // not greater
  std::vector<float> plain;
  LegForestScorer(InstructionSet::kPlain).score(forest, table, {}, plain);
  std::vector<float> widest;
  LegForestScorer().score(forest, table, {}, widest);
  EXPECT_EQ(plain, widest);
}

TEST(LegForestTest, ScoresOneScanAfterAnother) {
  const std::vector<LegTree> trees = random_trees(20, 5);
  const LegForest::Checkpoint checkpoints[] = {{5, 0.0F}};
  const LegForest forest{.trees = trees, .checkpoints = checkpoints};
  LegForestScorer used;
  std::vector<float> first;
  used.score(forest, random_table(50, 6), {}, first);
  std::vector<float> again;
  used.score(forest, random_table(20, 7), {}, again);
  std::vector<float> fresh;
  LegForestScorer().score(forest, random_table(20, 7), {}, fresh);
  EXPECT_EQ(again, fresh);
}

TEST(LegForestTest, AProbabilityIsTheLogisticOfTheCalibratedSum) {
  const LegForest forest{.slope = 2.0, .offset = -1.0};
  EXPECT_DOUBLE_EQ(forest.probability(0.5F), 0.5);
  EXPECT_NEAR(forest.probability(1.5F), 1.0 / (1.0 + std::exp(-2.0)), 1e-12);
  EXPECT_NEAR(forest.probability(1e9F), 1.0, 1e-12);
  EXPECT_NEAR(forest.probability(LegForestScorer::kGivenUp), 0.0, 1e-12);
}

}  // namespace
}  // namespace scanbed
