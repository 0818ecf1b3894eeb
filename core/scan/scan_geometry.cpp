// SPDX-License-Identifier: MIT
#include "core/scan/scan_geometry.hpp"

#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed {

std::string_view fault_of(const ScanGeometry& geometry) {
  constexpr double kMostTurn_rad = 2.0 * kPi + 1e-3;
  const int num_steps = geometry.num_beams > 1 ? geometry.num_beams - 1 : 1;
  // Written so that NaN fails, too.
  if (!(std::abs(geometry.first_rad) <= kMostTurn_rad)) {
    return "the first beam's angle is more than a turn, in radians";
  }
  if (!(std::abs(geometry.step_rad) * num_steps <= kMostTurn_rad)) {
    return "the beams are spread over more than a turn, in radians";
  }
  if (geometry.num_beams > 1 && geometry.step_rad == 0.0) return "all beams point the same way";
  if (geometry.timing.num_rotations < 1) return "the number of rotations is less than 1";
  if (std::isnan(geometry.max_range_m) || std::isnan(geometry.min_range_m)) {
    return "a range limit is no number";
  }
  return {};
}

void check_geometry(const ScanGeometry& geometry) {
  const std::string_view fault = fault_of(geometry);
  if (!fault.empty()) throw InputError(std::string(fault));
}

}  // namespace scanbed
