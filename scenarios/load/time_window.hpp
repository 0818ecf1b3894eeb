// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

namespace scanbed::scenarios {

/// A part of a run, both ends included.
struct TimeWindow {
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();

  bool contains(double time_s) const { return time_s >= from_s && time_s <= to_s; }
  bool is_whole() const { return from_s == 0.0 && to_s == std::numeric_limits<double>::infinity(); }
  bool operator==(const TimeWindow&) const = default;
};

/// "5 to 12 s".
std::string to_string(const TimeWindow& window);

}  // namespace scanbed::scenarios
