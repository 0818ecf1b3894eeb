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

bool has_bit(unsigned bits, int bit) {
  return ((bits >> bit) & 1U) != 0;
}

}  // namespace

double lms_step_m(RangeUnit unit) {
  return 1.0 / steps_per_metre(unit);
}

double lms_max_range_m(RangeUnit unit, int bits) {
  return lms_code(kLmsMaxSteps, bits) / steps_per_metre(unit);
}

std::uint16_t encode_lms_word(double range_m, RangeUnit unit, int bits) {
  if (range_m == kNoEcho) return lms_code(kLmsNoStopSignal, bits);
  if (std::isnan(range_m) || range_m == kTooClose) return lms_code(kLmsWeakSignal, bits);
  const double steps = std::max(range_m, 0.0) * steps_per_metre(unit) + 0.5;
  // A conversion to integer rounds down, once the number is known to fit.
  return steps >= lms_code(kLmsMaxSteps, bits) + 1.0 ? lms_code(kLmsBeyondMax, bits)
                                                     : static_cast<std::uint16_t>(steps);
}

double decode_lms_word(std::uint16_t word, RangeUnit unit, int bits) {
  const unsigned steps = word & ((1U << bits) - 1U);
  // Dividing gives the double nearest to the decimal number; multiplying by 0.001 would not.
  if (steps <= lms_code(kLmsMaxSteps, bits)) return steps / steps_per_metre(unit);
  if (steps == lms_code(kLmsNoStopSignal, bits) || steps == lms_code(kLmsBeyondMax, bits)) return kNoEcho;
  return kInvalid;
}

void round_to_lms_words(std::span<double> range_m, RangeUnit unit, int bits) {
  const double per_metre = steps_per_metre(unit);
  const double limit = lms_code(kLmsMaxSteps, bits) + 1.0;
  // Without branches, so that compilers can treat several ranges at once.
  for (double& range : range_m) {
    const double steps = (range > 0.0 ? range : 0.0) * per_metre + 0.5;
    const double fitting = steps < limit ? steps : 0.0;
    const double held_m = static_cast<std::int32_t>(fitting) / per_metre;
    const double in_reach_m = steps < limit ? held_m : kNoEcho;
    range = range > kTooClose ? in_reach_m : kInvalid;  // NaN is greater than nothing
  }
}

std::optional<LmsWordFormat> lms_word_format(int measuring_mode) {
  using Flags = LmsWordFormat::Flags;
  switch (measuring_mode) {
    case 0x00:
      return LmsWordFormat{13, Flags::kFieldsAbAndDazzle};
    case 0x01:
      return LmsWordFormat{13, Flags::kReflector};
    case 0x02:
      return LmsWordFormat{13, Flags::kFieldsAbc};
    case 0x03:
      return LmsWordFormat{14, Flags::kReflector};
    case 0x04:
      return LmsWordFormat{14, Flags::kFieldsAb};
    case 0x05:
      return LmsWordFormat{15, Flags::kReflector};
    case 0x06:
      return LmsWordFormat{15, Flags::kFieldA};
    case 0x0F:
      return LmsWordFormat{15, Flags::kNone};
    default:
      return std::nullopt;
  }
}

void decode_lms_words(std::span<const std::uint16_t> words, RangeUnit unit, const LmsWordFormat& format,
                      std::span<double> range_m) {
  SCANBED_ENSURE(words.size() == range_m.size());
  const int mask = (1 << format.range_bits) - 1;
  const int max_steps = mask - (kLmsRangeMask - kLmsMaxSteps);
  const int beyond_max = max_steps + 1;
  const double per_metre = steps_per_metre(unit);
  // Without branches, so that compilers can treat several words at once.
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int steps = words[i] & mask;
    const double code = steps == mask || steps == beyond_max ? kNoEcho : kInvalid;
    const double measured_m = steps / per_metre;
    range_m[i] = steps <= max_steps ? measured_m : code;
  }
}

LmsWordFlags lms_word_flags(std::uint16_t word, const LmsWordFormat& format) {
  using Flags = LmsWordFormat::Flags;
  const unsigned bits = static_cast<unsigned>(word) >> format.range_bits;
  LmsWordFlags flags;
  if (format.flags == Flags::kNone) return flags;
  if (format.flags == Flags::kReflector) {
    flags.reflector = static_cast<int>(bits);
    return flags;
  }
  flags.in_field_a = has_bit(bits, 0);
  flags.in_field_b = format.flags != Flags::kFieldA && has_bit(bits, 1);
  flags.in_field_c = format.flags == Flags::kFieldsAbc && has_bit(bits, 2);
  flags.is_dazzled = format.flags == Flags::kFieldsAbAndDazzle && has_bit(bits, 2);
  return flags;
}

}  // namespace scanbed
