// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/detect/feature_detector.hpp"
#include "core/scan/range_sensor.hpp"
#include "core/score/tally.hpp"
#include "scenarios/load/scenario.hpp"
#include "scenarios/run/analyst.hpp"
#include "scenarios/run/gates.hpp"
#include "scenarios/run/judge.hpp"
#include "sim/world/collision_watch.hpp"

namespace scanbed::scenarios {

/// How many features were detected, right or wrong.
struct FeatureCounts {
  std::int64_t lines = 0;
  std::int64_t circles = 0;
  std::int64_t legs = 0;
};

/// What one run of a scenario gave.
struct RunResult {
  std::string scenario;
  std::optional<std::uint64_t> seed;  ///< of a simulated laser's world
  std::string laser;                  ///< as `--laser` names it
  std::optional<std::string> engine;  ///< of a simulated laser
  std::string preset;                 ///< of the detector
  double duration_s = 0.0;
  int num_scans = 0;
  FeatureCounts features;
  std::optional<Scores> scores;   ///< empty where the laser has no truth
  std::vector<GateResult> gates;  ///< empty where there are no scores, or no needs
  std::vector<ExpectResult> expectations;
  std::vector<sim::Collision> collisions;  ///< of a simulated laser's world: what its script violates
  std::optional<std::string> known_fail;
  bool interrupted = false;  ///< stopped before the end of the stream

  bool met_its_gates() const;  ///< and its expectations; true where there are none
  bool is_accepted() const;    ///< met its gates, but for those that are known to fail
  /// A known failure that met all it was held to: its reason is out of date.
  bool passed_unexpectedly() const;
};

/// What is done with the scans of a run.
struct Processing {
  FeatureDetector& detector;
  AnalystOptions analysis = {};  ///< more is done anyway where the scenario is held to it
  std::string preset = {};       ///< that the detector's options began as: which needs hold for it
};

/// Called with each scan and its features; returns false to stop after it.
using ScanObserver = std::function<bool(const LaserScan&, const Features&)>;

/// Takes all scans of a sensor, detects, scores those that come with truth, and holds the scores against the
/// scenario's needs of the preset. Fills all fields but those of the laser and its world, which only the
/// caller knows.
///
/// @throws what the sensor's next() throws.
RunResult run_scenario(const Scenario& scenario, RangeSensor& sensor, const Processing& processing,
                       const ScanObserver& observer);

}  // namespace scanbed::scenarios
