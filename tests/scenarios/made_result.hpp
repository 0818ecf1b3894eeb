// SPDX-License-Identifier: MIT
#pragma once

#include "scenarios/run/run_scenario.hpp"
#include "tests/scenarios/made_scores.hpp"

namespace scanbed::testing {

/// A run with the scores of made_scores(), one gate passed and one missed.
inline scenarios::RunResult made_result() {
  using scenarios::FeatureKind;
  scenarios::RunResult result;
  result.scenario = "hall";
  result.seed = 7;
  result.laser = "sim";
  result.engine = "planar";
  result.preset = "paper";
  result.duration_s = 2.0;
  result.num_scans = 10;
  result.features = {0, 16, 1};
  result.scores = made_scores();
  const std::vector<scenarios::Need> needs = {
      {FeatureKind::kCircle, scenarios::find_metric("recall", FeatureKind::kCircle).value(), 0.75},
      {FeatureKind::kLine, scenarios::find_metric("recall", FeatureKind::kLine).value(), 0.9},
      {FeatureKind::kLeg, scenarios::find_metric("fp_per_scan", FeatureKind::kLeg).value(), 0.5}};
  for (const scenarios::Need& need : needs) result.gates.push_back(scenarios::evaluate(need, *result.scores));
  return result;
}

}  // namespace scanbed::testing
