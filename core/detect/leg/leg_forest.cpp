// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_forest.hpp"

#include <cmath>

namespace scanbed {
namespace {

constexpr int kBlock = LegFeatureTable::kBlock;

// Adds trees [first, last) to the sums of all candidates of the table.
void add_trees(std::span<const LegTree> trees, const LegFeatureTable& table, std::span<float> sums) {
  for (int begin = 0; begin < table.num_padded(); begin += kBlock) {
    std::array<float, kBlock> sum{};
    for (const LegTree& tree : trees) {
      std::array<std::int32_t, kBlock> leaf{};
      for (int level = 0; level < LegTree::kDepth; ++level) {
        const float* values = table.row(tree.feature[level]) + begin;
        const float threshold = tree.threshold[level];
        const std::int32_t bit = 1 << level;
        for (int lane = 0; lane < kBlock; ++lane) leaf[lane] |= values[lane] > threshold ? bit : 0;
      }
      for (int lane = 0; lane < kBlock; ++lane) sum[lane] += tree.value[leaf[lane]];
    }
    for (int lane = 0; lane < kBlock; ++lane) sums[begin + lane] += sum[lane];
  }
}

}  // namespace

double LegForest::probability(float sum) const {
  return 1.0 / (1.0 + std::exp(-(slope * sum + offset)));
}

// Moves the candidates that stay to the front.
void LegForestScorer::keep_above(float min_sum) {
  std::size_t num_kept = 0;
  for (std::size_t i = 0; i < candidate_.size(); ++i) {
    if (sums_[i] < min_sum) continue;
    for (int f = 0; f < kNumLegFeatures; ++f) table_.row(f)[num_kept] = table_.row(f)[i];
    sums_[num_kept] = sums_[i];
    candidate_[num_kept++] = candidate_[i];
  }
  candidate_.resize(num_kept);
  table_.shrink(static_cast<int>(num_kept));
}

void LegForestScorer::score(const LegForest& forest, const LegFeatureTable& table,
                            std::vector<float>& scores) {
  const int num_candidates = table.num_candidates();
  scores.assign(num_candidates, kGivenUp);
  table_ = table;
  sums_.assign(table.num_padded(), 0.0F);
  candidate_.resize(num_candidates);
  for (int i = 0; i < num_candidates; ++i) candidate_[i] = i;
  int num_done = 0;
  for (const LegForest::Checkpoint& checkpoint : forest.checkpoints) {
    add_trees(forest.trees.subspan(num_done, checkpoint.num_trees - num_done), table_, sums_);
    num_done = checkpoint.num_trees;
    keep_above(checkpoint.min_sum);
  }
  add_trees(forest.trees.subspan(num_done), table_, sums_);
  for (std::size_t i = 0; i < candidate_.size(); ++i) scores[candidate_[i]] = sums_[i];
}

}  // namespace scanbed
