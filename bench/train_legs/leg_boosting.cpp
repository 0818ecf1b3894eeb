// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_boosting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/generate/world_dice.hpp"

namespace scanbed::bench {
namespace {

constexpr double kMinCurvature = 1e-4;
constexpr double kMaxStep = 4.0;  // in log-odds, of one leaf before the rate

/// Slope and curvature of the loss, summed over the rows in each leaf.
struct LeafSums {
  std::array<double, LegTree::kNumLeaves> slope{};
  std::array<double, LegTree::kNumLeaves> curvature{};
};

class Booster {
 public:
  Booster(const LegTrainingRows& rows, const BoostingOptions& options)
      : rows_(rows), options_(options), dice_(options.seed, "boosting") {
    const std::size_t n = rows.is_leg.size();
    log_odds_.resize(n);
    slope_.resize(n);
    curvature_.resize(n);
    leaf_.resize(n);
    const double total = std::accumulate(rows.weight.begin(), rows.weight.end(), 0.0);
    unit_ = static_cast<double>(n) / total;
  }

  // Takes in what a tree says that was grown before.
  void follow(const LegTree& tree) {
    std::fill(leaf_.begin(), leaf_.end(), 0);
    for (int level = 0; level < LegTree::kDepth; ++level) split(tree, level);
    for (std::size_t i = 0; i < leaf_.size(); ++i) log_odds_[i] += tree.value[leaf_[i]];
  }

  LegTree grow() {
    differentiate();
    std::fill(leaf_.begin(), leaf_.end(), 0);
    LegTree tree;
    for (int level = 0; level < LegTree::kDepth; ++level) {
      ask(tree, level);
      split(tree, level);
    }
    const LeafSums sums = sums_of(tree, LegTree::kDepth - 1);
    for (int i = 0; i < LegTree::kNumLeaves; ++i) {
      const double step = sums.slope[i] / (sums.curvature[i] + options_.ridge);
      tree.value[i] = static_cast<float>(options_.rate * std::clamp(step, -kMaxStep, kMaxStep));
    }
    for (std::size_t i = 0; i < leaf_.size(); ++i) log_odds_[i] += tree.value[leaf_[i]];
    return tree;
  }

 private:
  // Of the rows that this tree sees; the others have none.
  void differentiate() {
    for (std::size_t i = 0; i < log_odds_.size(); ++i) {
      const double p = 1.0 / (1.0 + std::exp(-log_odds_[i]));
      const double weight = dice_.chance(options_.share) ? unit_ * rows_.weight[i] : 0.0;
      slope_[i] = weight * ((rows_.is_leg[i] != 0 ? 1.0 : 0.0) - p);
      curvature_[i] = weight * std::max(p * (1.0 - p), kMinCurvature);
    }
  }

  // Sums with the question of the level; the leaves of the levels before stand in leaf_.
  LeafSums sums_of(const LegTree& tree, int level) const {
    LeafSums sums;
    const std::vector<float>& column = rows_.columns[tree.feature[level]];
    const float threshold = tree.threshold[level];
    const unsigned mask = (1U << level) - 1U;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const unsigned leaf = (leaf_[i] & mask) | (column[i] > threshold ? 1U << level : 0U);
      sums.slope[leaf] += slope_[i];
      sums.curvature[leaf] += curvature_[i];
    }
    return sums;
  }

  void ask(LegTree& tree, int level) {
    std::array<int, kNumLegFeatures> order{};
    std::iota(order.begin(), order.end(), 0);
    LegTree best = tree;
    double best_gain = -1.0;
    for (int i = 0; i < std::min(options_.num_tries, options_.num_features); ++i) {
      std::swap(order[i], order[dice_.whole(i, options_.num_features - 1)]);
      const std::vector<float>& column = rows_.columns[order[i]];
      const float a = column[dice_.whole(0, rows_.size() - 1)];
      const float b = column[dice_.whole(0, rows_.size() - 1)];
      tree.feature[level] = static_cast<std::uint8_t>(order[i]);
      tree.threshold[level] = a + (b - a) * static_cast<float>(dice_.uniform(0.0, 1.0));
      const double gain = gain_of(sums_of(tree, level));
      if (gain <= best_gain) continue;
      best_gain = gain;
      best = tree;
    }
    tree = best;
  }

  void split(const LegTree& tree, int level) {
    const std::vector<float>& column = rows_.columns[tree.feature[level]];
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (column[i] > tree.threshold[level]) leaf_[i] |= static_cast<std::uint8_t>(1U << level);
    }
  }

  double gain_of(const LeafSums& sums) const {
    double gain = 0.0;
    for (int i = 0; i < LegTree::kNumLeaves; ++i) {
      gain += sums.slope[i] * sums.slope[i] / (sums.curvature[i] + options_.ridge);
    }
    return gain;
  }

  const LegTrainingRows& rows_;
  const BoostingOptions& options_;
  sim::WorldDice dice_;
  double unit_ = 1.0;  // makes the mean weight 1
  std::vector<double> log_odds_, slope_, curvature_;
  std::vector<std::uint8_t> leaf_;
};

}  // namespace

void LegTrainingRows::add(const std::array<float, kNumLegFeatures>& features, bool leg, double row_weight) {
  for (int f = 0; f < kNumLegFeatures; ++f) columns[f].push_back(features[f]);
  is_leg.push_back(leg ? 1 : 0);
  weight.push_back(row_weight);
}

std::vector<LegTree> boost(const LegTrainingRows& rows, const BoostingOptions& options,
                           std::vector<LegTree> trees) {
  Booster booster(rows, options);
  for (const LegTree& tree : trees) booster.follow(tree);
  for (int i = 0; i < options.num_trees; ++i) trees.push_back(booster.grow());
  return trees;
}

}  // namespace scanbed::bench
