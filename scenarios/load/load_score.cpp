// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/angles.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kGate{.least = 0.0, .greatest = 10.0, .open = true};

// What a bound may be: shares lie in [0, 1], the others only are not negative.
Allowed allowed_bound(const Metric& metric) {
  switch (metric.measure) {
    case Measure::kPrecision:
    case Measure::kRecall:
    case Measure::kRecallInBand:
    case Measure::kIdf1:
      return kShare;
    case Measure::kMota:
      return {.greatest = 1.0};
    case Measure::kFalsePerScan:
    case Measure::kRmsError:
    case Measure::kNumTruths:
    case Measure::kMotp:
    case Measure::kSwitchesPerMinute:
      break;
  }
  return {.least = 0.0};
}

// In the file's order, which is that of the results.
void load_bounds(const Value& value, FeatureKind kind, Scenario& scenario) {
  Table table(value);
  TimeWindow window;
  if (const auto between = table.take("between")) window = load_window(*between, scenario.duration_s);
  const std::optional<std::string> preset = take_preset(table);
  const std::optional<std::string> known_fail = take_known_fail(table);
  std::vector<std::pair<Metric, Value>> bounds;
  for (const std::string& name : metric_names(kind)) {
    if (const auto bound = table.take(name)) bounds.emplace_back(*find_metric(name, kind), *bound);
  }
  table.finish();
  if (bounds.empty()) value.refuse("asks for nothing" + name_hint("", metric_names(kind), "metrics"));
  const auto is_written_before = [](const auto& a, const auto& b) {
    return &a.second.node() < &b.second.node();
  };
  std::sort(bounds.begin(), bounds.end(), is_written_before);
  for (const auto& [metric, bound] : bounds) {
    scenario.needs.push_back({kind, metric, bound.number(allowed_bound(metric)), window, preset, known_fail});
  }
}

// One map of bounds, or a list of them for several windows of time, presets, known failures.
void load_needs(const Value& value, FeatureKind kind, Scenario& scenario) {
  if (value.node().kind != TreeNode::Kind::kList) return load_bounds(value, kind, scenario);
  const std::vector<Value> items = value.items();
  if (items.empty()) value.refuse("asks for nothing");
  for (const Value& item : items) load_bounds(item, kind, scenario);
}

void load_line_gate(Table& gate, MatchOptions& match) {
  match.line_angle_rad = radians(gate.number("angle_deg", degrees(match.line_angle_rad),
                                             {.least = 0.0, .greatest = 90.0, .open = true}));
  match.line_offset_m = gate.number("offset", match.line_offset_m, kGate);
  match.line_overlap_ratio =
      gate.number("overlap", match.line_overlap_ratio, {.least = 0.0, .greatest = 1.0, .open = true});
}

void load_gate(const Value& value, FeatureKind kind, MatchOptions& match) {
  Table gate(value);
  switch (kind) {
    case FeatureKind::kLine:
      load_line_gate(gate, match);
      break;
    case FeatureKind::kCircle:
      match.circle_center_m = gate.number("center", match.circle_center_m, kGate);
      match.circle_radius_m = gate.number("radius", match.circle_radius_m, kGate);
      break;
    case FeatureKind::kLeg:
      match.leg_center_m = gate.number("center", match.leg_center_m, kGate);
      break;
    case FeatureKind::kPerson:
      match.person_m = gate.number("center", match.person_m, kGate);
      break;
    case FeatureKind::kCylinder:
      match.cylinder_m = gate.number("center", match.cylinder_m, kGate);
      break;
  }
  gate.finish();
}

}  // namespace

void load_score(const Value& value, Scenario& scenario) {
  Table score(value);
  for (const FeatureKind kind : {FeatureKind::kLine, FeatureKind::kCircle, FeatureKind::kLeg,
                                 FeatureKind::kPerson, FeatureKind::kCylinder}) {
    const std::optional<Value> section = score.take(to_string(kind));
    if (!section) continue;
    Table table(*section);
    if (const auto gate = table.take("gate")) load_gate(*gate, kind, scenario.match);
    if (const auto need = table.take("need")) load_needs(*need, kind, scenario);
    table.finish();
    if (section->node().entries.empty()) section->refuse("asks for nothing; write need or gate");
  }
  score.finish();
}

}  // namespace scanbed::scenarios
