// SPDX-License-Identifier: MIT
#include "scenarios/load/need.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace scanbed::scenarios {
namespace {

std::vector<Metric> make_metrics() {
  std::vector<Metric> metrics = {{.name = "precision", .measure = Measure::kPrecision},
                                 {.name = "recall", .measure = Measure::kRecall},
                                 {.name = "fp_per_scan", .measure = Measure::kFalsePerScan, .at_most = true},
                                 {.name = "rms_error", .measure = Measure::kRmsError, .at_most = true},
                                 {.name = "truths", .measure = Measure::kNumTruths}};
  constexpr std::array kEdges_m = {0, 2, 4, 6, 8};
  for (std::size_t i = 0; i < kEdges_m.size(); ++i) {
    for (std::size_t j = i + 1; j < kEdges_m.size(); ++j) {
      metrics.push_back({.name = fmt::format("recall_{}_{}m", kEdges_m[i], kEdges_m[j]),
                         .measure = Measure::kRecallInBand,
                         .from_m = kEdges_m[i] * 1.0,
                         .to_m = kEdges_m[j] * 1.0});
    }
  }
  const auto add_of_tracks = [&](const char* name, Measure measure, bool at_most) {
    metrics.push_back({.name = name, .measure = measure, .of_tracks = true, .at_most = at_most});
  };
  add_of_tracks("mota", Measure::kMota, false);
  add_of_tracks("motp", Measure::kMotp, true);
  add_of_tracks("id_switches_per_minute", Measure::kSwitchesPerMinute, true);
  add_of_tracks("idf1", Measure::kIdf1, false);
  return metrics;
}

const std::vector<Metric>& all_metrics() {
  static const std::vector<Metric> metrics = make_metrics();
  return metrics;
}

bool has(FeatureKind kind, const Metric& metric) {
  const bool is_of_both = metric.measure == Measure::kNumTruths || metric.measure == Measure::kFalsePerScan;
  return is_of_both || metric.of_tracks == is_followed(kind);
}

std::vector<std::string> make_names_of_kind(bool followed) {
  std::vector<std::string> names;
  const FeatureKind kind = followed ? FeatureKind::kPerson : FeatureKind::kLine;
  for (const Metric& metric : all_metrics()) {
    if (has(kind, metric)) names.push_back(metric.name);
  }
  return names;
}

}  // namespace

bool is_followed(FeatureKind kind) {
  return kind == FeatureKind::kPerson || kind == FeatureKind::kCylinder;
}

std::string_view to_string(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kLine:
      return "line";
    case FeatureKind::kCircle:
      return "circle";
    case FeatureKind::kLeg:
      return "leg";
    case FeatureKind::kPerson:
      return "person";
    case FeatureKind::kCylinder:
      return "cylinder";
  }
  return "";
}

std::span<const std::string> metric_names(FeatureKind kind) {
  static const std::vector<std::string> of_features = make_names_of_kind(false);
  static const std::vector<std::string> of_tracks = make_names_of_kind(true);
  return is_followed(kind) ? of_tracks : of_features;
}

std::optional<Metric> find_metric(std::string_view name, FeatureKind kind) {
  for (const Metric& metric : all_metrics()) {
    if (metric.name == name && has(kind, metric)) return metric;
  }
  return std::nullopt;
}

}  // namespace scanbed::scenarios
