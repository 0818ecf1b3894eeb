// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/score/tally.hpp"
#include "scenarios/load/need.hpp"

namespace scanbed::scenarios {

/// One need and what a run measured.
struct GateResult {
  Need need;
  std::optional<double> value;  ///< empty where there was nothing to measure it by
  bool met = false;             ///< false also where there was nothing: a bar that nobody jumps is not passed
};

/// Of a kind that is found in single scans.
const KindScore& score_of(const Scores& scores, FeatureKind kind);

/// Of a kind that is followed; empty where nothing was.
const std::optional<TrackTally>& tracks_of(const Scores& scores, FeatureKind kind);

/// The metric's value; empty where it is a share or an error of nothing.
std::optional<double> measure(const Scores& scores, FeatureKind kind, const Metric& metric);

/// Whether a value reaches a need's bar.
bool is_met(const Need& need, double value);

/// Holds a need against the scores.
GateResult evaluate(const Need& need, const Scores& scores);

}  // namespace scanbed::scenarios
