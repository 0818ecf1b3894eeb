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
  int num_trees = 300;                 ///< to grow
  int num_features = kNumLegFeatures;  ///< the first so many are asked for
  double rate = 0.3;                   ///< share of a tree's own best values that is taken
  double least_chance = 0.1;           ///< that a tree sees a row that is as good as answered
  double ridge = 3.0;                  ///< added to the curvature of every leaf, in rows of mean weight
  std::uint64_t seed = 1;
};

/// Grows symmetric trees on the logistic loss, each on what those before leave over. Questions are random: a
/// threshold somewhere between a feature's values in two random rows. With few rows that leaves wider margins
/// than thresholds that fit them best. A tree sees all rows that those before answer badly, and of the others
/// the fewer, the better they are answered; who is seen counts for those who are not.
///
/// @par Source  Friedman, "Greedy Function Approximation: A Gradient Boosting Machine", Ann. Statist. 2001
///              (Newton steps); Geurts, Ernst & Wehenkel, "Extremely Randomized Trees", Mach. Learn. 2006
///              (random thresholds); Ke et al., "LightGBM", NIPS 2017 (rows by their slopes). Departs: all
///              nodes of a level share their question; the chance to be seen falls with the slope.
/// @param trees  go before those that are grown; what they leave over is learned.
std::vector<LegTree> boost(const LegTrainingRows& rows, const BoostingOptions& options,
                           std::vector<LegTree> trees = {});

}  // namespace scanbed::bench
