// SPDX-License-Identifier: MIT
#include "scenarios/run/run_scenario.hpp"

#include <algorithm>
#include <cstddef>

#include "core/score/scorer.hpp"

namespace scanbed::scenarios {
namespace {

// Longer than any laser needs for a scan; sources that never wait ignore it.
constexpr RangeSensor::Seconds kScanTimeout{2.0};

void count(const Features& features, FeatureCounts& counts) {
  counts.lines += static_cast<std::int64_t>(features.lines.size());
  counts.circles += static_cast<std::int64_t>(features.circles.size());
  counts.legs += static_cast<std::int64_t>(features.legs.size());
}

}  // namespace

bool RunResult::met_its_gates() const {
  return std::all_of(gates.begin(), gates.end(), [](const GateResult& gate) { return gate.met; });
}

RunResult run_scenario(const Scenario& scenario, RangeSensor& sensor, FeatureDetector& detector,
                       const ScanObserver& observer) {
  RunResult result;
  result.scenario = scenario.name;
  result.seed = scenario.seed;
  result.duration_s = scenario.duration_s;
  result.known_fail = scenario.known_fail;
  Scorer scorer(scenario.match);
  LaserScan scan;
  while (!result.interrupted && sensor.next(scan, kScanTimeout)) {
    ++result.num_scans;
    const Features& features = detector.detect(scan);
    count(features, result.features);
    if (const Truth* truth = sensor.truth()) scorer.add(features, scan, *truth);
    result.interrupted = !observer(scan, features);
  }
  if (scorer.scores().num_scans > 0) {
    result.scores = scorer.scores();
    result.gates = evaluate(scenario.needs, scorer.scores());
  }
  return result;
}

}  // namespace scanbed::scenarios
