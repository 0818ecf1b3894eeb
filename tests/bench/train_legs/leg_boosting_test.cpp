// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_boosting.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed::bench {
namespace {

using Features = std::array<float, kNumLegFeatures>;

double sum_of(const std::vector<LegTree>& trees, const Features& features) {
  double sum = 0.0;
  for (const LegTree& tree : trees) {
    int leaf = 0;
    for (int level = 0; level < LegTree::kDepth; ++level) {
      if (features[tree.feature[level]] > tree.threshold[level]) leaf |= 1 << level;
    }
    sum += tree.value[leaf];
  }
  return sum;
}

Features point(float a, float b) {
  Features features{};
  features[2] = a;
  features[9] = b;
  return features;
}

// A grid over two of the features; the others are all 0.
template <typename IsLeg>
LegTrainingRows grid(const IsLeg& is_leg) {
  LegTrainingRows rows;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 20; ++k) {
      const auto a = static_cast<float>(i) - 9.5F;
      const auto b = static_cast<float>(k) - 9.5F;
      rows.add(point(a, b), is_leg(a, b), 1.0);
    }
  }
  return rows;
}

TEST(LegBoostingTest, LearnsWhatOneThresholdTells) {
  const auto is_leg = [](float a, float) { return a > 0.0F; };
  const std::vector<LegTree> trees = boost(grid(is_leg), {.num_trees = 200});
  ASSERT_EQ(trees.size(), 200u);
  for (const float a : {-8.0F, -1.5F, 1.5F, 8.0F}) {
    for (const float b : {-5.0F, 5.0F})
      EXPECT_EQ(sum_of(trees, point(a, b)) > 0.0, a > 0.0F) << a << ' ' << b;
  }
}

// A corner is told by two questions of one tree.
TEST(LegBoostingTest, LearnsWhatTwoFeaturesTellTogether) {
  const auto is_leg = [](float a, float b) { return a > 0.0F && b > 0.0F; };
  const std::vector<LegTree> trees = boost(grid(is_leg), {.num_trees = 200});
  for (const float a : {-6.0F, 6.0F}) {
    for (const float b : {-6.0F, 6.0F}) {
      EXPECT_EQ(sum_of(trees, point(a, b)) > 0.0, is_leg(a, b)) << a << ' ' << b;
    }
  }
}

// The likeliest log-odds are those of the weights.
TEST(LegBoostingTest, WeightsCountLikeRows) {
  LegTrainingRows rows;
  for (int i = 0; i < 200; ++i) {
    rows.add(point(0.0F, 0.0F), true, 3.0);
    rows.add(point(0.0F, 0.0F), false, 1.0);
  }
  BoostingOptions options;
  options.num_trees = 400;
  // The ridge is a thousandth of the curvature; so many Newton steps have converged by far.
  EXPECT_NEAR(sum_of(boost(rows, options), point(0.0F, 0.0F)), std::log(3.0), 1e-3);
}

// Seven of ten are legs on one side, one of ten on the other: likeliest log-odds of log(7/3) and log(1/9),
// whether a tree sees all rows or few of those that it answers well.
TEST(LegBoostingTest, RowsThatAreNotSeenAreCountedForByOthers) {
  LegTrainingRows rows;
  for (int i = 0; i < 20000; ++i) {
    const bool right = i % 2 == 0;
    rows.add(point(right ? 1.0F : -1.0F, 0.0F), i / 2 % 10 < (right ? 7 : 1), 1.0);
  }
  for (const double least_chance : {1.0, 0.05}) {
    const std::vector<LegTree> trees = boost(rows, {.num_trees = 100, .least_chance = least_chance});
    // Of 9000 rows with slope 0.1 four of ten are seen: a step errs by sqrt(9000 x 0.01 x 1.5) / 900 = 0.013,
    // and 0.3 of each step are taken: 0.0055 in the end.
    EXPECT_NEAR(sum_of(trees, point(1.0F, 0.0F)), std::log(7.0 / 3.0), 0.04);
    EXPECT_NEAR(sum_of(trees, point(-1.0F, 0.0F)), std::log(1.0 / 9.0), 0.04);
  }
}

TEST(LegBoostingTest, IsTheSameForTheSameSeed) {
  const LegTrainingRows rows = grid([](float a, float b) { return a + b > 0.0F; });
  BoostingOptions options{.num_trees = 5};
  const std::vector<LegTree> trees = boost(rows, options);
  const std::vector<LegTree> again = boost(rows, options);
  options.seed = 2;
  const std::vector<LegTree> other = boost(rows, options);
  bool differs = false;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    EXPECT_EQ(trees[i].threshold, again[i].threshold);
    EXPECT_EQ(trees[i].value, again[i].value);
    differs |= trees[i].threshold != other[i].threshold;
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace scanbed::bench
