// SPDX-License-Identifier: MIT
#include "core/detect/table_two.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "core/detect/circle_detector.hpp"
#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

using Options = DetectorOptions;

constexpr double kMmPerM = 1000.0;

const std::array<TableTwoEntry, 12> kTableTwo = {{
    {"laser", 0, "", "", "index of the laser device; there is one", 0, 0, true,
     [](const Options&) { return 0.0; }, [](Options&, double) {}},
    {"seg_threshold", 80, "mm", "segmentation.max_gap_m",
     "neighbouring points farther apart belong to different segments", 1, 10000, false,
     [](const Options& o) { return o.segmentation.max_gap_m * kMmPerM; },
     [](Options& o, double v) { o.segmentation.max_gap_m = v / kMmPerM; }},
    {"circles", 1, "", "circle.method", "algorithm for circles: 0 off, 1 inscribed angle variance", 0, 1,
     true, [](const Options& o) { return static_cast<double>(o.circle.method); },
     [](Options& o, double v) { o.circle.method = static_cast<CircleMethod>(static_cast<int>(v)); }},
    {"lines", 1, "", "line.method",
     "algorithm for lines: 0 off, 1 recursive line fitting, 2 inscribed angles of 180 degrees", 0, 2, true,
     [](const Options& o) { return static_cast<double>(o.line.method); },
     [](Options& o, double v) { o.line.method = static_cast<LineMethod>(static_cast<int>(v)); }},
    {"legs", 1, "", "leg.enabled", "algorithm for legs: 0 off, 1 geometrical relations", 0, 1, true,
     [](const Options& o) { return o.leg.enabled ? 1.0 : 0.0; },
     [](Options& o, double v) { o.leg.enabled = v != 0.0; }},
    {"circle_std_max", 0.15, "rad", "circle.max_std_rad",
     "largest standard deviation of the inscribed angles; above 0.15 also arc-like shapes", 0.001,
     kMaxArcLikeStd_rad, false, [](const Options& o) { return o.circle.max_std_rad; },
     [](Options& o, double v) { o.circle.max_std_rad = v; }},
    {"circle_max_len", 99999, "mm", "circle.max_length_m", "longer segments are not analysed for circles", 1,
     999999, false, [](const Options& o) { return o.circle.max_length_m * kMmPerM; },
     [](Options& o, double v) { o.circle.max_length_m = v / kMmPerM; }},
    {"circle_min_len", 150, "mm", "circle.min_length_m", "shorter segments are not analysed for circles", 0,
     99999, false, [](const Options& o) { return o.circle.min_length_m * kMmPerM; },
     [](Options& o, double v) { o.circle.min_length_m = v / kMmPerM; }},
    {"circle_min_pts", 4, "", "circle.min_points", "segments with fewer points are not analysed for circles",
     3, 10000, true, [](const Options& o) { return static_cast<double>(o.circle.min_points); },
     [](Options& o, double v) { o.circle.min_points = static_cast<int>(v); }},
    {"line_min_len", 150, "mm", "line.min_length_m", "shorter runs are no lines", 0, 99999, false,
     [](const Options& o) { return o.line.min_length_m * kMmPerM; },
     [](Options& o, double v) { o.line.min_length_m = v / kMmPerM; }},
    {"line_min_pts", 5, "", "line.min_points", "runs with fewer points are no lines", 2, 10000, true,
     [](const Options& o) { return static_cast<double>(o.line.min_points); },
     [](Options& o, double v) { o.line.min_points = static_cast<int>(v); }},
    {"line_err", 0.1, "m", "line.max_error_m", "a run splits where a point lies farther off its line", 0.001,
     10, false, [](const Options& o) { return o.line.max_error_m; },
     [](Options& o, double v) { o.line.max_error_m = v; }},
}};

std::string allowed_range(const TableTwoEntry& entry) {
  std::ostringstream text;
  if (entry.min_value == entry.max_value) {
    text << entry.min_value;
  } else {
    text << (entry.whole_number ? "whole numbers in [" : "[") << entry.min_value << ", " << entry.max_value
         << "]";
  }
  if (!entry.unit.empty()) text << " " << entry.unit;
  return text.str();
}

std::string known_names() {
  std::string names;
  for (const TableTwoEntry& entry : kTableTwo) names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

}  // namespace

std::span<const TableTwoEntry> table_two() {
  return kTableTwo;
}

void set_table_two(DetectorOptions& options, std::string_view name, double value) {
  const auto entry =
      std::find_if(kTableTwo.begin(), kTableTwo.end(), [&](const auto& e) { return e.name == name; });
  if (entry == kTableTwo.end()) {
    throw InputError("unknown parameter '" + std::string(name) + "'; known: " + known_names());
  }
  const bool in_range = value >= entry->min_value && value <= entry->max_value;
  const bool whole = !entry->whole_number || value == std::floor(value);
  require(in_range && whole, name, value, allowed_range(*entry));
  entry->set(options, value);
}

}  // namespace scanbed
