// SPDX-License-Identifier: MIT
#include "core/scan/lms_word.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/scan/laser_scan.hpp"

namespace scanbed {
namespace {

constexpr RangeUnit kMm = RangeUnit::kMillimetre;
constexpr RangeUnit kCm = RangeUnit::kCentimetre;

TEST(LmsWordTest, HoldsMillimetresOrCentimetres) {
  EXPECT_EQ(encode_lms_word(1.234, kMm), 1234);
  EXPECT_EQ(encode_lms_word(12.34, kCm), 1234);
  EXPECT_EQ(decode_lms_word(1234, kMm), 1.234);
  EXPECT_EQ(decode_lms_word(1234, kCm), 12.34);
  EXPECT_EQ(lms_step_m(kMm), 0.001);
  EXPECT_EQ(lms_step_m(kCm), 0.01);
}

TEST(LmsWordTest, RoundsToTheNearestStep) {
  EXPECT_EQ(encode_lms_word(1.2344, kMm), 1234);
  EXPECT_EQ(encode_lms_word(1.2346, kMm), 1235);
  EXPECT_EQ(encode_lms_word(1.234, kCm), 123);
  EXPECT_EQ(encode_lms_word(1.236, kCm), 124);
}

TEST(LmsWordTest, TheGreatestRangeIsOneStepBelowTheFirstCode) {
  EXPECT_EQ(lms_max_range_m(kMm), 8.182);
  EXPECT_EQ(lms_max_range_m(kCm), 81.82);
  EXPECT_EQ(encode_lms_word(8.182, kMm), 0x1FF6);
  EXPECT_EQ(encode_lms_word(8.183, kMm), 0x1FF7);
  EXPECT_EQ(encode_lms_word(8.183, kCm), 818);
  EXPECT_EQ(encode_lms_word(81.83, kCm), 0x1FF7);
  EXPECT_EQ(encode_lms_word(1e300, kMm), 0x1FF7);
}

TEST(LmsWordTest, NothingIsNearerThanZero) {
  EXPECT_EQ(encode_lms_word(0.0, kMm), 0);
  EXPECT_EQ(encode_lms_word(-0.004, kMm), 0);
  EXPECT_EQ(decode_lms_word(0, kMm), 0.0);
}

TEST(LmsWordTest, NoEchoAndTooFarAreInfinite) {
  EXPECT_EQ(decode_lms_word(0x1FFF, kMm), kNoEcho);
  EXPECT_EQ(decode_lms_word(0x1FF7, kCm), kNoEcho);
  EXPECT_EQ(encode_lms_word(kNoEcho, kMm), 0x1FFF);
}

TEST(LmsWordTest, FaultsOfTheMeasurementAreInvalid) {
  for (const int word : {0x1FF8, 0x1FF9, 0x1FFA, 0x1FFB, 0x1FFC, 0x1FFD, 0x1FFE}) {
    EXPECT_TRUE(std::isnan(decode_lms_word(static_cast<std::uint16_t>(word), kMm))) << std::hex << word;
  }
  EXPECT_EQ(encode_lms_word(kInvalid, kMm), 0x1FFB);
  EXPECT_EQ(encode_lms_word(kTooClose, kMm), 0x1FFB);
}

TEST(LmsWordTest, FlagsDoNotChangeTheRange) {
  EXPECT_EQ(decode_lms_word(0xE000 | 1234, kMm), 1.234);
  EXPECT_EQ(decode_lms_word(0xFFFF, kMm), kNoEcho);
  EXPECT_TRUE(std::isnan(decode_lms_word(0xFFFE, kMm)));
}

TEST(LmsWordTest, EveryRangeWordComesBack) {
  for (int word = 0; word <= 0x1FF6; ++word) {
    for (const RangeUnit unit : {kMm, kCm}) {
      ASSERT_EQ(encode_lms_word(decode_lms_word(static_cast<std::uint16_t>(word), unit), unit), word);
    }
  }
}

RC_GTEST_PROP(LmsWordTest, IsWithinHalfAStepOfTheRange, ()) {
  const double range_m = *rc::gen::inRange(0, 8182000) / 1e6;
  const double decoded_m = decode_lms_word(encode_lms_word(range_m, kMm), kMm);
  RC_ASSERT(std::abs(decoded_m - range_m) <= 0.0005 + 1e-12);
}

// SICK's overflow codes of the three widths: xFFF, xFFE and xFF7 with x = 1, 3 and 7.
TEST(LmsWordTest, ManyRangesAreRoundedAsOneByOne) {
  for (const RangeUnit unit : {RangeUnit::kMillimetre, RangeUnit::kCentimetre}) {
    for (const int bits : {13, 14, 15}) {
      std::vector<double> range_m = {kNoEcho, kTooClose, kInvalid, -1.0, -0.0, 0.0, 1e300};
      for (int i = 0; i < 4000; ++i) range_m.push_back(0.0123456 * i);
      const std::vector<double> given_m = range_m;
      round_to_lms_words(range_m, unit, bits);
      for (std::size_t i = 0; i < given_m.size(); ++i) {
        const double expected_m = decode_lms_word(encode_lms_word(given_m[i], unit, bits), unit, bits);
        const bool is_same = range_m[i] == expected_m || (std::isnan(range_m[i]) && std::isnan(expected_m));
        EXPECT_TRUE(is_same) << given_m[i] << ": " << range_m[i] << ", not " << expected_m;
      }
    }
  }
}

TEST(LmsWordTest, WiderWordsReachFartherAndKeepTheirCodes) {
  EXPECT_EQ(lms_max_range_m(kMm, 14), 16.374);
  EXPECT_EQ(lms_max_range_m(kMm, 15), 32.758);
  EXPECT_EQ(lms_code(kLmsDazzled, 13), 0x1FFE);
  EXPECT_EQ(lms_code(kLmsDazzled, 14), 0x3FFE);
  EXPECT_EQ(lms_code(kLmsDazzled, 15), 0x7FFE);
  EXPECT_EQ(encode_lms_word(20.0, kMm, 15), 20000);
  EXPECT_EQ(encode_lms_word(20.0, kMm, 14), 0x3FF7);
  EXPECT_EQ(encode_lms_word(kNoEcho, kMm, 15), 0x7FFF);
  for (const int bits : {13, 14, 15}) {
    EXPECT_EQ(decode_lms_word(encode_lms_word(1.234, kMm, bits), kMm, bits), 1.234);
    EXPECT_EQ(decode_lms_word(lms_code(kLmsNoStopSignal, bits), kMm, bits), kNoEcho);
    EXPECT_EQ(decode_lms_word(lms_code(kLmsBeyondMax, bits), kMm, bits), kNoEcho);
    EXPECT_TRUE(std::isnan(decode_lms_word(lms_code(kLmsDazzled, bits), kMm, bits)));
  }
  EXPECT_EQ(decode_lms_word(0x1FFE, kMm, 14), 8.190);  // a range there, not a code
}

double decoded_m(int word, std::uint8_t mode, RangeUnit unit = kMm) {
  const std::uint16_t words[] = {static_cast<std::uint16_t>(word)};
  double range_m[1];
  decode_lms_words(words, unit, *lms_word_format(mode), range_m);
  return range_m[0];
}

TEST(LmsWordTest, MeasuringModesSayHowManyBitsTheRangeHas) {
  EXPECT_EQ(lms_max_range_m(kMm, lms_word_format(0x00)->range_bits), 8.182);
  EXPECT_EQ(lms_max_range_m(kMm, lms_word_format(0x03)->range_bits), 16.374);
  EXPECT_EQ(lms_max_range_m(kMm, lms_word_format(0x05)->range_bits), 32.758);
  EXPECT_EQ(decoded_m(0x4000 | 12345, 0x04), 12.345);
  EXPECT_EQ(decoded_m(0x8000 | 23456, 0x06), 23.456);
  EXPECT_EQ(decoded_m(23456, 0x0F, kCm), 234.56);
}

TEST(LmsWordTest, OverflowCodesFillTheRangeBitsOfEachMode) {
  for (const auto& [mode, top] : {std::pair{0x00, 0x1FFF}, {0x03, 0x3FFF}, {0x06, 0x7FFF}}) {
    const auto m = static_cast<std::uint8_t>(mode);
    EXPECT_EQ(decoded_m(top, m), kNoEcho);
    EXPECT_EQ(decoded_m(top - 8, m), kNoEcho);
    for (const int below : {1, 2, 3, 4, 5, 6, 7}) EXPECT_TRUE(std::isnan(decoded_m(top - below, m)));
    EXPECT_EQ(decoded_m(top - 9, m), (top - 9) / 1000.0);
  }
}

TEST(LmsWordTest, FlagsAreWhatTheModePutsAboveTheRange) {
  const LmsWordFlags dazzled = lms_word_flags(0xA000, *lms_word_format(0x00));
  EXPECT_TRUE(dazzled.in_field_a && !dazzled.in_field_b && dazzled.is_dazzled && !dazzled.in_field_c);
  const LmsWordFlags fields = lms_word_flags(0xC000, *lms_word_format(0x02));
  EXPECT_TRUE(!fields.in_field_a && fields.in_field_b && fields.in_field_c && !fields.is_dazzled);
  EXPECT_EQ(lms_word_flags(0xE000, *lms_word_format(0x01)).reflector, 7);
  EXPECT_EQ(lms_word_flags(0xC000, *lms_word_format(0x03)).reflector, 3);
  EXPECT_EQ(lms_word_flags(0x8000, *lms_word_format(0x05)).reflector, 1);
  EXPECT_TRUE(lms_word_flags(0x8000, *lms_word_format(0x04)).in_field_b);
  const LmsWordFlags one = lms_word_flags(0x8000, *lms_word_format(0x06));
  EXPECT_TRUE(one.in_field_a && !one.in_field_b);
  EXPECT_FALSE(lms_word_flags(0xFFFF, *lms_word_format(0x0F)).in_field_a);
}

TEST(LmsWordTest, ReflectivityAndUnknownModesHaveNoRanges) {
  EXPECT_FALSE(lms_word_format(0x3F).has_value());
  EXPECT_FALSE(lms_word_format(0x07).has_value());
}

TEST(LmsWordTest, AllWordsAtOnceAreTheWordsOneByOne) {
  for (int word = 0; word <= 0xFFFF; ++word) {
    const double one_m = decode_lms_word(static_cast<std::uint16_t>(word), kMm);
    const double all_m = decoded_m(word, 0x00);
    ASSERT_TRUE(one_m == all_m || (std::isnan(one_m) && std::isnan(all_m))) << word;
  }
}

}  // namespace
}  // namespace scanbed
