// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_forest.hpp"

#include <cmath>

#include "core/simd/float_lanes.hpp"

#if defined(SCANBED_HAS_AVX2)
#include <immintrin.h>
#endif

namespace scanbed {
namespace {

constexpr int kBlock = LegFeatureTable::kBlock;
static_assert(kBlock == kNumLanes);

// The leaf of each candidate of a block.
[[gnu::always_inline]] inline void find_leaves(const LegTree& tree, const float* block, Ints& leaves) {
  leaves = Ints{};
  Floats values;
  for (int level = 0; level < LegTree::kDepth; ++level) {
    load(block + kBlock * tree.feature[level], values);
    leaves |= (values > tree.threshold[level]) & (1 << level);
  }
}

// Adds what the trees say of a block's candidates to their sums.
void add_trees_plain(std::span<const LegTree> trees, const float* block, float* sums) {
  Ints leaves;
  for (const LegTree& tree : trees) {
    find_leaves(tree, block, leaves);
    for (int lane = 0; lane < kBlock; ++lane) sums[lane] += tree.value[leaves[lane]];
  }
}

#if defined(SCANBED_HAS_AVX2)
static_assert(LegTree::kNumLeaves == 2 * kNumLanes);

// A tree's values fill two registers, from which each lane picks its own.
SCANBED_AVX2 void add_trees_avx2(std::span<const LegTree> trees, const float* block, float* sums) {
  __m256 sum = _mm256_loadu_ps(sums);
  Ints leaves;
  for (const LegTree& tree : trees) {
    find_leaves(tree, block, leaves);
    const auto leaf = reinterpret_cast<__m256i>(leaves);
    const __m256 low = _mm256_permutevar8x32_ps(_mm256_loadu_ps(tree.value.data()), leaf);
    const __m256 high = _mm256_permutevar8x32_ps(_mm256_loadu_ps(tree.value.data() + kNumLanes), leaf);
    // The blend goes by the highest bit of a lane; which half it is says bit 3.
    const __m256 is_high = _mm256_castsi256_ps(_mm256_slli_epi32(leaf, 28));
    sum = _mm256_add_ps(sum, _mm256_blendv_ps(low, high, is_high));
  }
  _mm256_storeu_ps(sums, sum);
}
#endif

void add_trees(InstructionSet set, std::span<const LegTree> trees, const float* block, float* sums) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return add_trees_avx2(trees, block, sums);
#endif
  add_trees_plain(trees, block, sums);
}

}  // namespace

double LegForest::probability(float sum) const {
  return 1.0 / (1.0 + std::exp(-(slope * sum + offset)));
}

void LegForestScorer::add(std::span<const LegTree> trees) {
  for (int i = 0; i < table_.num_blocks(); ++i) {
    add_trees(instructions_, trees, table_.block(i), sums_.data() + static_cast<std::ptrdiff_t>(i) * kBlock);
  }
}

// Moves the candidates that stay to the front, if blocks become free by that.
void LegForestScorer::keep_above(float min_sum) {
  for (float& sum : sums_) {
    if (sum < min_sum) sum = kGivenUp;
  }
  const auto stays = [&](std::size_t i) { return sums_[i] > kGivenUp / 2; };
  int num_kept = 0;
  for (std::size_t i = 0; i < candidate_.size(); ++i) num_kept += stays(i) ? 1 : 0;
  if ((num_kept + kBlock - 1) / kBlock == table_.num_blocks()) return;
  int to = 0;
  for (std::size_t i = 0; i < candidate_.size(); ++i) {
    if (!stays(i)) continue;
    if (to != static_cast<int>(i)) table_.copy(static_cast<int>(i), to);
    sums_[to] = sums_[i];
    candidate_[to++] = candidate_[i];
  }
  candidate_.resize(num_kept);
  table_.shrink(num_kept);
}

void LegForestScorer::score(const LegForest& forest, const LegFeatureTable& table,
                            std::span<const LegPlace> places, std::vector<float>& scores) {
  const int num_candidates = table.num_candidates();
  scores.assign(num_candidates, kGivenUp);
  table_ = table;
  sums_.assign(static_cast<std::size_t>(table.num_blocks()) * kBlock, 0.0F);
  candidate_.resize(num_candidates);
  for (int i = 0; i < num_candidates; ++i) candidate_[i] = i;
  add(forest.trees.first(forest.num_alone));
  if (!places.empty()) partner_reader_.read(places, sums_, table_);
  int num_done = forest.num_alone;
  for (const LegForest::Checkpoint& checkpoint : forest.checkpoints) {
    add(forest.trees.subspan(num_done, checkpoint.num_trees - num_done));
    num_done = checkpoint.num_trees;
    keep_above(checkpoint.min_sum);
  }
  add(forest.trees.subspan(num_done));
  for (std::size_t i = 0; i < candidate_.size(); ++i) {
    if (sums_[i] > kGivenUp / 2) scores[candidate_[i]] = sums_[i];
  }
}

}  // namespace scanbed
