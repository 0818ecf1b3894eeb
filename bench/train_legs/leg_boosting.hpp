// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/detect/leg/leg_forest.hpp"

namespace scanbed::bench {

/// What a forest learns from: row i has the features column[f][i], is a leg or not, and counts weight[i]
/// times.
struct LegTrainingRows {
  std::array<std::vector<float>, kNumLegFeatures> columns;
  std::vector<char> is_leg;
  std::vector<double> weight;

  int size() const { return static_cast<int>(is_leg.size()); }
  void add(const std::array<float, kNumLegFeatures>& features, bool leg, double row_weight);
};

struct BoostingOptions {
  int num_trees = 300;
  double rate = 0.12;  ///< share of a tree's own best values that is taken
  int num_tries = 16;  ///< random questions of which each level asks the best
  double share = 0.7;  ///< of the rows that a tree sees
  double ridge = 1.0;  ///< added to the curvature of every leaf, in rows of mean weight
  std::uint64_t seed = 1;
};

/// Grows symmetric trees on the logistic loss, each on what those before leave over. Questions are random: a
/// feature, and a threshold somewhere between its values in two random rows. With few rows that leaves wider
/// margins than thresholds that fit them best.
///
/// @par Source  Friedman, "Greedy Function Approximation: A Gradient Boosting Machine", Ann. Statist. 2001
///              (Newton steps); Geurts, Ernst & Wehenkel, "Extremely Randomized Trees", Mach. Learn. 2006
///              (random thresholds). Departs: all nodes of a level share their question.
std::vector<LegTree> boost(const LegTrainingRows& rows, const BoostingOptions& options);

}  // namespace scanbed::bench
