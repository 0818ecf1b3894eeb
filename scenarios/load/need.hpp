// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scenarios/load/time_window.hpp"

namespace scanbed::scenarios {

/// What is scored: features of a scan, or what is followed over scans.
enum class FeatureKind { kLine, kCircle, kLeg, kPerson, kCylinder };

/// Whether tracks are scored for it rather than features.
bool is_followed(FeatureKind kind);

/// "line", "circle", "leg", "person" or "cylinder".
std::string_view to_string(FeatureKind kind);

enum class Measure {
  kPrecision,
  kRecall,
  kRecallInBand,
  kFalsePerScan,
  kRmsError,
  kNumTruths,
  kMota,
  kMotp,
  kSwitchesPerMinute,
  kIdf1,
};

/// What a gate measures: one number of a kind's score.
struct Metric {
  std::string name;  ///< in scenario files: "precision", "recall_0_4m", ...
  Measure measure = Measure::kPrecision;
  double from_m = 0.0;  ///< kRecallInBand: truths at ranges of [from_m, to_m)
  double to_m = 0.0;
  bool of_tracks = false;  ///< of people and cylinders; else of features
  bool at_most = false;    ///< the bound is the greatest allowed value, not the least
};

/// "precision", "recall", "recall_0_2m" to "recall_6_8m" (and the wider bands between 0, 2, 4, 6 and 8 m),
/// "fp_per_scan", "rms_error", "truths"; of people and cylinders "mota", "motp", "id_switches_per_minute",
/// "idf1", "fp_per_scan", "truths".
std::span<const std::string> metric_names(FeatureKind kind);

/// Empty where the kind has no metric of that name.
std::optional<Metric> find_metric(std::string_view name, FeatureKind kind);

/// One bar that a run must reach.
struct Need {
  FeatureKind kind = FeatureKind::kLine;
  Metric metric;
  double bound = 0.0;
  TimeWindow window = {};                      ///< scans that it is measured over
  std::optional<std::string> preset = {};      ///< of the detector that is held to it; empty: any
  std::optional<std::string> known_fail = {};  ///< why it is not met yet; a miss is then reported only
};

}  // namespace scanbed::scenarios
