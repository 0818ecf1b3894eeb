// SPDX-License-Identifier: MIT
#include "core/scan/lms_word.hpp"

#include <algorithm>
#include <cmath>

#include "core/scan/laser_scan.hpp"

namespace scanbed {
namespace {

double steps_per_metre(RangeUnit unit) {
  return unit == RangeUnit::kMillimetre ? 1000.0 : 100.0;
}

}  // namespace

double lms_step_m(RangeUnit unit) {
  return 1.0 / steps_per_metre(unit);
}

double lms_max_range_m(RangeUnit unit) {
  return kLmsMaxSteps / steps_per_metre(unit);
}

std::uint16_t encode_lms_word(double range_m, RangeUnit unit) {
  if (range_m == kNoEcho) return kLmsNoStopSignal;
  if (std::isnan(range_m) || range_m == kTooClose) return kLmsWeakSignal;
  const double steps = std::floor(std::max(range_m, 0.0) * steps_per_metre(unit) + 0.5);
  return steps > kLmsMaxSteps ? kLmsBeyondMax : static_cast<std::uint16_t>(steps);
}

double decode_lms_word(std::uint16_t word, RangeUnit unit) {
  const unsigned steps = word & kLmsRangeMask;
  // Dividing gives the double nearest to the decimal number; multiplying by 0.001 would not.
  if (steps <= kLmsMaxSteps) return steps / steps_per_metre(unit);
  if (steps == kLmsNoStopSignal || steps == kLmsBeyondMax) return kNoEcho;
  return kInvalid;
}

}  // namespace scanbed
