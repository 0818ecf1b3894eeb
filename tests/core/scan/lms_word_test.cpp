// SPDX-License-Identifier: MIT
#include "core/scan/lms_word.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

}  // namespace
}  // namespace scanbed
