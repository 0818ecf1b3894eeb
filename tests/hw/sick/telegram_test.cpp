// SPDX-License-Identifier: MIT
#include "hw/sick/telegram.hpp"

#include <gtest/gtest.h>

#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;

TEST(TelegramTest, FramesAsPrinted) {
  EXPECT_EQ(frame_telegram(0x00, from_hex("31")), from_hex("02 00 01 00 31 15 12"));
  EXPECT_EQ(frame_telegram(0x80, from_hex("A0 00 10")), from_hex("02 80 03 00 A0 00 10 16 0A"));
  EXPECT_EQ(frame_telegram(0x81, from_hex("A0 00 10")), from_hex("02 81 03 00 A0 00 10 36 1A"));
  EXPECT_EQ(frame_telegram(0x80, from_hex("92 10")), from_hex("02 80 02 00 92 10 7F 33"));
}

TEST(TelegramTest, WordsAreLittleEndian) {
  Bytes bytes;
  append_word(bytes, 0x1234);
  EXPECT_EQ(bytes, from_hex("34 12"));
  EXPECT_EQ(read_word(bytes, 0), 0x1234U);
}

TEST(TelegramTest, RefusesBodiesThatNoTelegramHas) {
  EXPECT_DEATH(frame_telegram(0, {}), "broken promise");
  EXPECT_DEATH(frame_telegram(0, Bytes(809)), "broken promise");
  EXPECT_EQ(frame_telegram(0, Bytes(808)).size(), 814U);
}

}  // namespace
}  // namespace scanbed::hw
