// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_boosting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/simd/double_lanes.hpp"
#include "sim/generate/world_dice.hpp"

namespace scanbed::bench {
namespace {

constexpr double kMinCurvature = 1e-4;
constexpr double kMaxStep = 4.0;      // in log-odds, of one leaf before the rate
constexpr double kSurelySeen = 0.25;  // slope of a row that every tree sees

/// Slope and curvature of the loss, summed over the rows in each leaf.
using LeafSums = std::array<Doubles, LegTree::kNumLeaves>;

class Booster {
 public:
  Booster(const LegTrainingRows& rows, const BoostingOptions& options)
      : rows_(rows), options_(options), dice_(options.seed, "boosting") {
    const std::size_t n = rows.is_leg.size();
    log_odds_.resize(n);
    leaf_.resize(n);
    const double total = std::accumulate(rows.weight.begin(), rows.weight.end(), 0.0);
    unit_ = static_cast<double>(n) / total;
  }

  // Takes in what a tree says, of all rows.
  void follow(const LegTree& tree) {
    std::fill(leaf_.begin(), leaf_.end(), 0);
    for (int level = 0; level < LegTree::kDepth; ++level) {
      const std::vector<float>& column = rows_.columns[tree.feature[level]];
      for (std::size_t i = 0; i < leaf_.size(); ++i)
        leaf_[i] = static_cast<std::uint8_t>(leaf_[i] | bit_of(tree, level, column[i]));
    }
    for (std::size_t i = 0; i < leaf_.size(); ++i) log_odds_[i] += tree.value[leaf_[i]];
  }

  LegTree grow() {
    draw_rows();
    LegTree tree;
    LeafSums sums{};
    for (int level = 0; level < LegTree::kDepth; ++level) sums = ask(tree, level);
    for (int i = 0; i < LegTree::kNumLeaves; ++i) {
      const double step = sums[i][0] / (sums[i][1] + options_.ridge);
      tree.value[i] = static_cast<float>(options_.rate * std::clamp(step, -kMaxStep, kMaxStep));
    }
    follow(tree);
    return tree;
  }

 private:
  /// A row that the tree sees.
  struct Seen {
    Doubles loss;  ///< slope and curvature
    int row = 0;
    unsigned leaf = 0;
  };

  static unsigned bit_of(const LegTree& tree, int level, float value) {
    return value > tree.threshold[level] ? 1U << level : 0U;
  }

  void draw_rows() {
    seen_.clear();
    for (int i = 0; i < rows_.size(); ++i) {
      const double p = 1.0 / (1.0 + std::exp(-log_odds_[i]));
      const double slope = (rows_.is_leg[i] != 0 ? 1.0 : 0.0) - p;
      const double chance = std::clamp(std::abs(slope) / kSurelySeen, options_.least_chance, 1.0);
      if (!dice_.chance(chance)) continue;
      const double weight = unit_ * rows_.weight[i] / chance;
      seen_.push_back({weight * Doubles{slope, std::max(p * (1.0 - p), kMinCurvature)}, i, 0});
    }
  }

  // Sums with the question of the level; what those before say stands in seen_.
  LeafSums sums_of(const LegTree& tree, int level) const {
    LeafSums sums{};
    const std::vector<float>& column = rows_.columns[tree.feature[level]];
    for (const Seen& seen : seen_) sums[seen.leaf | bit_of(tree, level, column[seen.row])] += seen.loss;
    return sums;
  }

  // The question of a random threshold that gains most; returns what it parts.
  LeafSums ask(LegTree& tree, int level) {
    LegTree best = tree;
    LeafSums best_sums{};
    double best_gain = -1.0;
    for (int feature = 0; feature < options_.num_features; ++feature) {
      const std::vector<float>& column = rows_.columns[feature];
      const float a = column[dice_.whole(0, rows_.size() - 1)];
      const float b = column[dice_.whole(0, rows_.size() - 1)];
      tree.feature[level] = static_cast<std::uint8_t>(feature);
      tree.threshold[level] = a + (b - a) * static_cast<float>(dice_.uniform(0.0, 1.0));
      const LeafSums sums = sums_of(tree, level);
      const double gain = gain_of(sums);
      if (gain <= best_gain) continue;
      best_gain = gain;
      best_sums = sums;
      best = tree;
    }
    tree = best;
    const std::vector<float>& column = rows_.columns[tree.feature[level]];
    for (Seen& seen : seen_) seen.leaf |= bit_of(tree, level, column[seen.row]);
    return best_sums;
  }

  double gain_of(const LeafSums& sums) const {
    double gain = 0.0;
    for (const Doubles& sum : sums) gain += sum[0] * sum[0] / (sum[1] + options_.ridge);
    return gain;
  }

  const LegTrainingRows& rows_;
  const BoostingOptions& options_;
  sim::WorldDice dice_;
  double unit_ = 1.0;  // makes the mean weight 1
  std::vector<double> log_odds_;
  std::vector<std::uint8_t> leaf_;
  std::vector<Seen> seen_;
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
