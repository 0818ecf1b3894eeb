// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace scanbed {

/// Step of a range on the wire.
enum class RangeUnit { kMillimetre, kCentimetre };

// The 13-bit words of an LMS 2xx in measuring mode 00: bits 0 to 12 hold the range in steps or one of the
// codes below; bits 13 to 15 are flags (field A, field B, dazzle).
inline constexpr std::uint16_t kLmsRangeMask = 0x1FFF;
inline constexpr std::uint16_t kLmsMaxSteps = 0x1FF6;      ///< the greatest range that is no code
inline constexpr std::uint16_t kLmsBeyondMax = 0x1FF7;     ///< measured range greater than the greatest
inline constexpr std::uint16_t kLmsChannelError = 0x1FFA;  ///< reading channel 1 failed
inline constexpr std::uint16_t kLmsWeakSignal = 0x1FFB;    ///< signal-to-noise ratio too small
inline constexpr std::uint16_t kLmsCalculationOverflow = 0x1FFD;  ///< the sensor's arithmetic overflowed
inline constexpr std::uint16_t kLmsDazzled = 0x1FFE;              ///< blinded by light
inline constexpr std::uint16_t kLmsNoStopSignal = 0x1FFF;         ///< no echo came back

/// 0.001 or 0.01 m.
double lms_step_m(RangeUnit unit);

// Other measuring modes give 14 or 15 bits to the range and fewer to the flags; the codes keep their low 13
// bits, the added ones are set. So kLmsDazzled is 1FFE, 3FFE or 7FFE.

/// The greatest range that a word can hold: of 13 bits 8.182 or 81.82 m.
double lms_max_range_m(RangeUnit unit, int bits = 13);

/// A code of the 13-bit words as words of `bits` bits (13 to 15) have it.
std::uint16_t lms_code(std::uint16_t code, int bits);

/// Range to word, rounded to the nearest step; negative ranges become 0. Beyond the greatest range:
/// kLmsBeyondMax; kNoEcho: kLmsNoStopSignal; kInvalid and kTooClose: kLmsWeakSignal, since the LMS has no
/// code for "too close". No flag is set.
std::uint16_t encode_lms_word(double range_m, RangeUnit unit, int bits = 13);

/// Word to range; flags are ignored. No echo (kLmsNoStopSignal) and an echo from too far (kLmsBeyondMax) are
/// kNoEcho; every other value above kLmsMaxSteps, listed above or not, is kInvalid (REP 117).
///
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", measured value overflow codes.
double decode_lms_word(std::uint16_t word, RangeUnit unit, int bits = 13);

}  // namespace scanbed
