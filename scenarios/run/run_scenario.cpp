// SPDX-License-Identifier: MIT
#include "scenarios/run/run_scenario.hpp"

#include <algorithm>
#include <cstddef>

namespace scanbed::scenarios {
namespace {

void count(const Features& features, FeatureCounts& counts) {
  counts.lines += static_cast<std::int64_t>(features.lines.size());
  counts.circles += static_cast<std::int64_t>(features.circles.size());
  counts.legs += static_cast<std::int64_t>(features.legs.size());
}

bool needs_tracks(const Scenario& scenario) {
  return std::any_of(scenario.needs.begin(), scenario.needs.end(),
                     [](const Need& need) { return is_followed(need.kind); });
}

bool needs_scene(const Scenario& scenario) {
  return std::any_of(scenario.expectations.begin(), scenario.expectations.end(),
                     [](const Expectation& expectation) { return expectation.condition.needs_scene(); });
}

AnalystOptions analysis_of(const Scenario& scenario, const Processing& processing) {
  AnalystOptions options = processing.analysis;
  options.track = options.track || needs_tracks(scenario);
  options.interpret = options.interpret || needs_scene(scenario);
  return options;
}

}  // namespace

bool RunResult::met_its_gates() const {
  return std::all_of(gates.begin(), gates.end(), [](const GateResult& gate) { return gate.met; }) &&
         std::all_of(expectations.begin(), expectations.end(),
                     [](const ExpectResult& expectation) { return expectation.met; });
}

bool RunResult::is_accepted() const {
  return known_fail.has_value() ||
         (std::all_of(gates.begin(), gates.end(),
                      [](const GateResult& gate) { return gate.met || gate.need.known_fail; }) &&
          std::all_of(expectations.begin(), expectations.end(), [](const ExpectResult& expectation) {
            return expectation.met || expectation.expectation.known_fail;
          }));
}

bool RunResult::passed_unexpectedly() const {
  const bool is_measured = !gates.empty() || !expectations.empty();
  return known_fail.has_value() && is_measured && !interrupted && met_its_gates();
}

RunResult run_scenario(const Scenario& scenario, RangeSensor& sensor, const Processing& processing,
                       const ScanObserver& observer) {
  RunResult result;
  result.scenario = scenario.name;
  result.duration_s = scenario.duration_s;
  result.known_fail = scenario.known_fail;
  result.preset = processing.preset;
  Judge judge(scenario, processing.preset);
  Analyst analyst(processing.detector, analysis_of(scenario, processing));
  LaserScan scan;
  while (!result.interrupted && sensor.next(scan, RangeSensor::kPatience)) {
    ++result.num_scans;
    const Findings found = analyst.analyse(scan);
    count(found.features, result.features);
    judge.add({scan, found.features, sensor.truth(), found.tracks, found.scene});
    result.interrupted = !observer(scan, found.features);
  }
  result.scores = judge.scores();
  result.gates = judge.gates();
  result.expectations = judge.expectations();
  return result;
}

}  // namespace scanbed::scenarios
