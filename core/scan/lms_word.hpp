// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

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
constexpr std::uint16_t lms_code(std::uint16_t code, int bits) {
  return static_cast<std::uint16_t>(code | ((1U << bits) - 1U - kLmsRangeMask));
}

/// Range to word, rounded to the nearest step; negative ranges become 0. Beyond the greatest range:
/// kLmsBeyondMax; kNoEcho: kLmsNoStopSignal; kInvalid and kTooClose: kLmsWeakSignal, since the LMS has no
/// code for "too close". No flag is set.
std::uint16_t encode_lms_word(double range_m, RangeUnit unit, int bits = 13);

/// Word to range; flags are ignored. No echo (kLmsNoStopSignal) and an echo from too far (kLmsBeyondMax) are
/// kNoEcho; every other value above kLmsMaxSteps, listed above or not, is kInvalid (REP 117).
///
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", measured value overflow codes.
double decode_lms_word(std::uint16_t word, RangeUnit unit, int bits = 13);

/// Ranges to those that their words hold: decode_lms_word(encode_lms_word(r)) of each r, many at a time.
void round_to_lms_words(std::span<double> range_m, RangeUnit unit, int bits = 13);

/// What the 16 bits of a word hold: the range below, flags above it. Which of them depends on the sensor's
/// measuring mode.
struct LmsWordFormat {
  int range_bits = 13;  ///< 13, 14 or 15: 8, 16 or 32 m in millimetres
  /// What stands in the bits above the range, from bit range_bits up.
  enum class Flags { kFieldsAbAndDazzle, kReflector, kFieldsAbc, kFieldsAb, kFieldA, kNone };
  Flags flags = Flags::kFieldsAbAndDazzle;

  friend bool operator==(const LmsWordFormat&, const LmsWordFormat&) = default;
};

/// What a word says beside its range.
struct LmsWordFlags {
  bool in_field_a = false;
  bool in_field_b = false;
  bool in_field_c = false;
  bool is_dazzled = false;
  int reflector = 0;  ///< brightness of a reflector in the steps that the mode has; 0 is none
};

/// Format of measuring modes 00 to 06 and 0F; empty for others, which carry no ranges (3F: reflectivity) or
/// do not exist.
///
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", measuring modes.
std::optional<LmsWordFormat> lms_word_format(int measuring_mode);

/// Words to ranges as decode_lms_word does it, in any format: the codes of the 14- and 15-bit formats are
/// those of the 13-bit one with the further bits set (3FFFh, 7FFFh: no echo).
/// @pre  as many ranges as words. Checked; aborts.
void decode_lms_words(std::span<const std::uint16_t> words, RangeUnit unit, const LmsWordFormat& format,
                      std::span<double> range_m);

LmsWordFlags lms_word_flags(std::uint16_t word, const LmsWordFormat& format);

}  // namespace scanbed
