// SPDX-License-Identifier: MIT
#include "core/scan/lms_word.hpp"

#include <algorithm>
#include <cmath>

#include "core/errors/ensure.hpp"
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

double lms_max_range_m(RangeUnit unit, int bits) {
  return lms_code(kLmsMaxSteps, bits) / steps_per_metre(unit);
}

std::uint16_t lms_code(std::uint16_t code, int bits) {
  SCANBED_ENSURE(bits >= 13 && bits <= 15);
  return static_cast<std::uint16_t>(code | ((1U << bits) - 1U - kLmsRangeMask));
}

std::uint16_t encode_lms_word(double range_m, RangeUnit unit, int bits) {
  if (range_m == kNoEcho) return lms_code(kLmsNoStopSignal, bits);
  if (std::isnan(range_m) || range_m == kTooClose) return lms_code(kLmsWeakSignal, bits);
  const double steps = std::floor(std::max(range_m, 0.0) * steps_per_metre(unit) + 0.5);
  return steps > lms_code(kLmsMaxSteps, bits) ? lms_code(kLmsBeyondMax, bits)
                                              : static_cast<std::uint16_t>(steps);
}

double decode_lms_word(std::uint16_t word, RangeUnit unit, int bits) {
  const unsigned steps = word & ((1U << bits) - 1U);
  // Dividing gives the double nearest to the decimal number; multiplying by 0.001 would not.
  if (steps <= lms_code(kLmsMaxSteps, bits)) return steps / steps_per_metre(unit);
  if (steps == lms_code(kLmsNoStopSignal, bits) || steps == lms_code(kLmsBeyondMax, bits)) return kNoEcho;
  return kInvalid;
}

}  // namespace scanbed
