// SPDX-License-Identifier: MIT
#include "hw/sick/scan_telegram.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hw/sick/telegram.hpp"
#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;

std::string check_word(const Bytes& body) {
  const Bytes telegram = frame_telegram(0x80, body);
  char text[8];
  std::snprintf(text, sizeof text, "%02X %02X", telegram[telegram.size() - 2], telegram.back());
  return text;
}

ScanTelegram same_values(std::size_t count, int value) {
  ScanTelegram telegram;
  telegram.words.assign(count, static_cast<std::uint16_t>(value));
  return telegram;
}

TEST(ScanTelegramTest, EncodesPrintedTelegrams) {
  ScanTelegram rising = same_values(361, 0);
  for (int i = 0; i < 361; ++i)
    rising.words[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(1000 + i);
  const Bytes body = encode(rising);
  EXPECT_EQ(body.size(), 726U);  // a telegram of 732 bytes
  EXPECT_EQ(Bytes(body.begin(), body.begin() + 7), from_hex("B0 69 41 E8 03 E9 03"));
  EXPECT_EQ(check_word(body), "86 0C");
  EXPECT_EQ(check_word(encode(same_values(361, 2000))), "80 8E");
  EXPECT_EQ(check_word(encode(same_values(361, 0))), "32 14");
}

TEST(ScanTelegramTest, EncodesPrintedPartials) {
  ScanTelegram first = same_values(181, 2000);
  first.is_partial = true;
  const Bytes body = encode(first);
  EXPECT_EQ(Bytes(body.begin(), body.begin() + 5), from_hex("B0 B5 60 D0 07"));
  EXPECT_EQ(check_word(body), "8D 13");
  ScanTelegram second = same_values(180, 2000);
  second.is_partial = true;
  second.partial = 1;
  const Bytes other = encode(second);
  EXPECT_EQ(Bytes(other.begin(), other.begin() + 5), from_hex("B0 B4 68 D0 07"));
  EXPECT_EQ(check_word(other), "B9 B4");
}

TEST(ScanTelegramTest, ParsesAPrintedTelegram) {
  const Bytes body = from_hex("B0 04 40 E8 03 FE 1F FF 1F D0 27 10");
  EXPECT_EQ(check_word(body), "F0 D5");
  EXPECT_EQ(check_word(from_hex("B0 04 40 E8 03 FE 1F FF 1F D0 27 92")), "72 D5");
  ScanTelegram telegram;
  ASSERT_TRUE(parse_scan(body, telegram));
  EXPECT_EQ(telegram.words, (std::vector<std::uint16_t>{1000, 0x1FFE, 0x1FFF, 0x27D0}));
  EXPECT_EQ(telegram.unit, RangeUnit::kMillimetre);
  EXPECT_FALSE(telegram.is_partial);
  EXPECT_FALSE(telegram.indices.has_value());
  EXPECT_EQ(telegram.status.bits, 0x10);
}

TEST(ScanTelegramTest, ReadsIndicesAndStatusApart) {
  ScanTelegram telegram;
  ASSERT_TRUE(parse_scan(from_hex("B0 01 00 E8 03 07 2A 92"), telegram));
  EXPECT_EQ(telegram.unit, RangeUnit::kCentimetre);
  ASSERT_TRUE(telegram.indices.has_value());
  EXPECT_EQ(telegram.indices->scan, 7);
  EXPECT_EQ(telegram.indices->telegram, 42);
  EXPECT_TRUE(telegram.status.is_polluted());
  EXPECT_EQ(telegram.status.severity(), 2);
}

TEST(ScanTelegramTest, RefusesLengthsThatDoNotMatchTheCount) {
  ScanTelegram telegram;
  for (const char* body : {"", "B0", "B0 01 40", "B0 02 40 E8 03 10", "B0 01 40 E8 03 00 10",
                           "B0 01 80 E8 03 10", "B1 01 40 E8 03 10"}) {
    EXPECT_FALSE(parse_scan(from_hex(body), telegram)) << body;
  }
}

TEST(ScanTelegramTest, MatchesWhatWasConfigured) {
  const ScanTelegram scan = same_values(361, 5);
  EXPECT_TRUE(matches(scan, {.variant = {180, 50}}));
  EXPECT_FALSE(matches(scan, {.variant = {180, 100}}));
  EXPECT_FALSE(matches(scan, {.variant = {180, 50}, .unit = RangeUnit::kCentimetre}));
  EXPECT_FALSE(matches(scan, {.variant = {180, 50}, .has_indices = true}));
  EXPECT_FALSE(matches(scan, {.variant = {180, 50}, .is_partial = true}));
  ScanTelegram turn = same_values(180, 5);
  turn.is_partial = true;
  turn.partial = 3;
  EXPECT_TRUE(matches(turn, {.is_partial = true}));
  turn.partial = 0;  // the first turn has 181
  EXPECT_FALSE(matches(turn, {.is_partial = true}));
}

// The check word misses these; the count, the unit or the length then disagrees.
TEST(ScanTelegramTest, BlindPairsInTheHeadAreNoticed) {
  const Bytes body = encode(same_values(361, 2000));
  for (std::size_t at = 0; at < 3; ++at) {
    for (int bit = 0; bit < 7; ++bit) {
      Bytes damaged = body;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1 << bit));
      damaged[at + 1] = static_cast<std::uint8_t>(damaged[at + 1] ^ (2 << bit));
      ScanTelegram telegram;
      EXPECT_FALSE(parse_scan(damaged, telegram) && matches(telegram, {.variant = {180, 50}}));
    }
  }
}

RC_GTEST_PROP(ScanTelegramTest, ComesBackAsItWasSent, ()) {
  ScanTelegram sent;
  sent.words = *rc::gen::container<std::vector<std::uint16_t>>(401, rc::gen::arbitrary<std::uint16_t>());
  sent.words.resize(*rc::gen::inRange<std::size_t>(0, 402));
  sent.unit = *rc::gen::element(RangeUnit::kMillimetre, RangeUnit::kCentimetre);
  sent.partial = *rc::gen::inRange(0, 4);
  if (*rc::gen::arbitrary<bool>()) sent.indices = {{1, 2}};
  ScanTelegram got;
  RC_ASSERT(parse_scan(encode(sent), got));
  RC_ASSERT(got.words == sent.words);
  RC_ASSERT(got.unit == sent.unit);
  RC_ASSERT(got.partial == sent.partial);
  RC_ASSERT(got.indices.has_value() == sent.indices.has_value());
}

}  // namespace
}  // namespace scanbed::hw
