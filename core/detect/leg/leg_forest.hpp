// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/detect/leg/leg_features.hpp"
#include "core/detect/leg/leg_partners.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// A symmetric tree: five questions, asked of every candidate whatever the answers before, select one of 32
/// values. Bit i of the value's index says whether feature[i] is greater than threshold[i].
struct LegTree {
  static constexpr int kDepth = 5;
  static constexpr int kNumLeaves = 1 << kDepth;

  std::array<std::uint8_t, kDepth> feature{};  ///< of LegFeature
  std::array<float, kDepth> threshold{};
  std::array<float, kNumLeaves> value{};
};

/// Boosted trees whose values add up to the log-odds of a candidate to be a leg.
struct LegForest {
  /// After num_trees, candidates whose sum is below the bound are given up.
  struct Checkpoint {
    int num_trees = 0;
    float min_sum = 0.0F;
  };
  std::span<const LegTree> trees;
  std::span<const Checkpoint> checkpoints;  ///< rising; none before num_alone
  /// So many trees judge each candidate by itself. What they add up to tells the others how likely the
  /// candidate's neighbours are legs.
  int num_alone = 0;
  // Calibration on candidates that were not trained on.
  double slope = 1.0;
  double offset = 0.0;

  /// Probability that a candidate with this sum is a leg: 1 / (1 + exp(-(slope sum + offset))).
  ///
  /// @par Source  Platt, "Probabilistic Outputs for Support Vector Machines", Advances in Large Margin
  ///              Classifiers, 1999.
  double probability(float sum) const;
};

/// The forest that comes with the detector, made by `./dev train-legs`.
const LegForest& trained_leg_forest();

/// Adds up a forest over many candidates at once. Keeps its buffers.
class LegForestScorer {
 public:
  /// What given-up candidates get.
  static constexpr float kGivenUp = -1e9F;

  explicit LegForestScorer(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions), partner_reader_(instructions) {}

  /// @param places  of the table's candidates. Without any, the table has what they say of each other.
  /// @param scores  overwritten: sum of the forest's values of each candidate, or kGivenUp.
  void score(const LegForest& forest, const LegFeatureTable& table, std::span<const LegPlace> places,
             std::vector<float>& scores);

 private:
  void add(std::span<const LegTree> trees);
  void keep_above(float min_sum);
  void move(int from, int to);
  bool stays(int i) const { return sums_[i] > kGivenUp / 2; }

  InstructionSet instructions_;
  LegPartnerReader partner_reader_;
  LegFeatureTable table_;    ///< of the candidates still in the race
  std::vector<float> sums_;  ///< kGivenUp or so: out of the race, though a lane of its block
  std::vector<int> candidate_;
  std::vector<int> gaps_, movers_;
};

}  // namespace scanbed
