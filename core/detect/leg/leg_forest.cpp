// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_forest.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simd/float_lanes.hpp"

#if defined(SCANBED_HAS_AVX2)
#include <immintrin.h>
#endif

namespace scanbed {
namespace {

constexpr int kBlock = LegFeatureTable::kBlock;
static_assert(kBlock == kNumLanes);

// Of addresses, that they need not be widened.
constexpr std::size_t kStride = kBlock;
constexpr std::size_t kBlockStride = kStride * kNumLegFeatures;  // from one block of the table to the next

// Whether the features that the tree asks for on a level are above its threshold, of a block's candidates.
[[gnu::always_inline]] inline void answer(const LegTree& tree, int level, const float* block, Ints& answers) {
  Floats values;
  load(block + kStride * tree.feature[level], values);
  answers = values > tree.threshold[level];
}

// The leaf of each candidate of a block as far as the levels below `end` tell.
[[gnu::always_inline]] inline void find_leaves(const LegTree& tree, int end, const float* block,
                                               Ints& leaves) {
  Ints answers;
  leaves = Ints{};
  for (int level = 0; level < end; ++level) {
    answer(tree, level, block, answers);
    leaves |= answers & (1 << level);
  }
}

// Adds what the trees say of a block's candidates to their sums.
void add_trees_plain(std::span<const LegTree> trees, const float* block, float* sums) {
  Ints leaves;
  for (const LegTree& tree : trees) {
    find_leaves(tree, LegTree::kDepth, block, leaves);
    for (int lane = 0; lane < kBlock; ++lane) sums[lane] += tree.value[leaves[lane]];
  }
}

#if defined(SCANBED_HAS_AVX2)
constexpr int kInRegister = 3;  // levels that tell values apart which share a register
constexpr int kNumRegisters = LegTree::kNumLeaves / kBlock;
static_assert(1 << kInRegister == kBlock);

// What the tree says of a block's candidates: each lane picks its own value from every register by the first
// levels, then the others halve what was picked.
[[gnu::always_inline]] SCANBED_AVX2 inline __m256 pick_values(const LegTree& tree, const float* block) {
  Ints in_register, is_upper;
  find_leaves(tree, kInRegister, block, in_register);
  const auto index = reinterpret_cast<__m256i>(in_register);
  __m256 picked[kNumRegisters];
  for (int i = 0; i < kNumRegisters; ++i) {
    picked[i] = _mm256_permutevar8x32_ps(_mm256_loadu_ps(tree.value.data() + kStride * i), index);
  }
  for (int level = kInRegister; level < LegTree::kDepth; ++level) {
    answer(tree, level, block, is_upper);
    const std::ptrdiff_t num_left = 1 << (LegTree::kDepth - 1 - level);
    for (std::ptrdiff_t i = 0; i < num_left; ++i) {
      picked[i] = _mm256_blendv_ps(picked[2 * i], picked[2 * i + 1], reinterpret_cast<__m256>(is_upper));
    }
  }
  return picked[0];
}

// Does so for several blocks at once: what is loaded of a tree serves them all.
template <int kNumBlocks>
SCANBED_AVX2 void add_trees_avx2(std::span<const LegTree> trees, const float* blocks, float* sums) {
  __m256 sum[kNumBlocks];
  for (int i = 0; i < kNumBlocks; ++i) sum[i] = _mm256_loadu_ps(sums + kStride * i);
  for (const LegTree& tree : trees) {
    for (int i = 0; i < kNumBlocks; ++i) {
      sum[i] = _mm256_add_ps(sum[i], pick_values(tree, blocks + kBlockStride * i));
    }
  }
  for (int i = 0; i < kNumBlocks; ++i) _mm256_storeu_ps(sums + kStride * i, sum[i]);
}
#endif

// Adds what the trees say of the first blocks, and tells how many it has done.
int add_trees(InstructionSet set, std::span<const LegTree> trees, std::span<const float> blocks,
              float* sums) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) {
    constexpr std::array kAdd = {add_trees_avx2<1>, add_trees_avx2<2>, add_trees_avx2<3>, add_trees_avx2<4>,
                                 add_trees_avx2<5>, add_trees_avx2<6>, add_trees_avx2<7>, add_trees_avx2<8>};
    const std::size_t num_blocks = std::min(blocks.size() / kBlockStride, kAdd.size());
    kAdd[num_blocks - 1](trees, blocks.data(), sums);
    return static_cast<int>(num_blocks);
  }
#endif
  add_trees_plain(trees, blocks.data(), sums);
  return 1;
}

}  // namespace

double LegForest::probability(float sum) const {
  return 1.0 / (1.0 + std::exp(-(slope * sum + offset)));
}

void LegForestScorer::add(std::span<const LegTree> trees) {
  for (int i = 0; i < table_.num_blocks();) {
    i += add_trees(instructions_, trees, table_.blocks_from(i), sums_.data() + kStride * i);
  }
}

// Fills the gaps among the first candidates with what stays behind them, if blocks become free by that.
// Collects both without a jump: who stays cannot be foretold.
void LegForestScorer::keep_above(float min_sum) {
  const int num_candidates = table_.num_candidates();
  int num_kept = 0;
  for (int i = 0; i < num_candidates; ++i) {
    sums_[i] = sums_[i] < min_sum ? kGivenUp : sums_[i];
    num_kept += stays(i) ? 1 : 0;
  }
  if ((num_kept + kBlock - 1) / kBlock == table_.num_blocks()) return;
  const std::size_t room = candidate_.size();
  if (gaps_.size() < room) gaps_.resize(room);
  if (movers_.size() < room) movers_.resize(room);
  int num_gaps = 0;
  for (int i = 0; i < num_kept; ++i) {
    gaps_[num_gaps] = i;
    num_gaps += stays(i) ? 0 : 1;
  }
  int num_movers = 0;
  for (int i = num_kept; i < num_candidates; ++i) {
    movers_[num_movers] = i;
    num_movers += stays(i) ? 1 : 0;
  }
  for (int i = 0; i < num_gaps; ++i) move(movers_[i], gaps_[i]);
  candidate_.resize(num_kept);
  table_.shrink(num_kept);
}

void LegForestScorer::move(int from, int to) {
  table_.copy(from, to);
  sums_[to] = sums_[from];
  candidate_[to] = candidate_[from];
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
  for (int i = 0; i < table_.num_candidates(); ++i) {
    if (stays(i)) scores[candidate_[i]] = sums_[i];
  }
}

}  // namespace scanbed
