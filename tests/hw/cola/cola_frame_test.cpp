// SPDX-License-Identifier: MIT
#include "hw/cola/cola_frame.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

std::vector<std::string> bodies(ByteView bytes) {
  ColaReader reader;
  reader.feed(bytes);
  std::vector<std::string> all;
  for (std::string body; reader.next(body);) all.push_back(body);
  return all;
}

TEST(ColaFrameTest, IsThatOfTheListing) {
  EXPECT_EQ(
      frame_cola("sMN SetAccessMode 03 F4724744"),
      tests::from_hex(
          "02 73 4D 4E 20 53 65 74 41 63 63 65 73 73 4D 6F 64 65 20 30 33 20 46 34 37 32 34 37 34 34 03"));
  EXPECT_EQ(frame_cola("sRN LMPscancfg"), tests::from_hex("02 73 52 4E 20 4C 4D 50 73 63 61 6E 63 66 67 03"));
  EXPECT_EQ(frame_cola("sRA LMPscancfg 1388 1 1388 FFF92230 225510").size(), 44u);
}

TEST(ColaFrameTest, FindsTheFrameBehindGarbage) {
  EXPECT_EQ(bodies(bytes_of("xx\x02sRA bro\x02sRA SCdevicestate 1\x03")),
            std::vector<std::string>{"sRA SCdevicestate 1"});
  EXPECT_EQ(bodies(bytes_of("\x03\x02"
                            "a\x03\r\n\x02"
                            "b\x03\x02")),
            (std::vector<std::string>{"a", "b"}));
}

TEST(ColaFrameTest, AnEndlessFrameIsDropped) {
  ColaReader reader;
  std::string body;
  reader.feed(bytes_of("\x02"));
  for (int i = 0; i < 300; ++i) {
    reader.feed(Bytes(1024, 'x'));
    EXPECT_FALSE(reader.next(body));
  }
  reader.feed(bytes_of("\x02ok\x03"));
  ASSERT_TRUE(reader.next(body));
  EXPECT_EQ(body, "ok");
}

TEST(ColaFrameTest, FourStartsInARowAreCoLaB) {
  const Bytes binary = tests::from_hex("02 02 02 02 00 00 00 05 73 46 41 00 03 7B");
  ColaReader whole;
  whole.feed(binary);
  EXPECT_TRUE(whole.is_binary());
  ColaReader pieces;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FALSE(pieces.is_binary());
    pieces.feed(ByteView(binary).subspan(i, 1));
  }
  EXPECT_TRUE(pieces.is_binary());
  ColaReader text;
  text.feed(bytes_of("\x02\x02\x02sRA a\x03\x02sRA b\x03"));
  EXPECT_FALSE(text.is_binary());
}

TEST(ColaTokensTest, NumbersAreThoseOfTheListing) {
  ColaTokens tokens("FFF92230 225510 3F800000 40000000 1388 x 123456789 -1");
  EXPECT_EQ(tokens.next_signed(), -450000);
  EXPECT_EQ(tokens.next_signed(), 2250000);
  EXPECT_EQ(tokens.next_float(), 1.0F);
  EXPECT_EQ(tokens.next_float(), 2.0F);
  EXPECT_EQ(tokens.next_hex(), 5000u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(tokens.next_hex(), std::nullopt);
  EXPECT_EQ(tokens.next(), "");
}

TEST(ColaTokensTest, WritesAsDevicesDo) {
  EXPECT_EQ(to_cola_hex(std::uint32_t{5000}), "1388");
  EXPECT_EQ(to_cola_hex(std::uint32_t{0}), "0");
  EXPECT_EQ(to_cola_hex(1.0F), "3F800000");
  EXPECT_EQ(to_cola_hex(0.0F), "00000000");
}

TEST(ColaErrorTest, HasAText) {
  EXPECT_EQ(cola_error_text(0xA), "write access denied (not logged in)");
  EXPECT_EQ(cola_error_text(0x1A), "error 1A");
}

RC_GTEST_PROP(ColaFrameTest, BodiesComeBackHoweverTheyArrive, ()) {
  const Bytes all = bytes_of("\x02sRA a 1\x03zz\x02sSN b\x03");
  ColaReader reader;
  std::vector<std::string> found;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t count = std::min(*rc::gen::inRange<std::size_t>(1, 9), all.size() - at);
    reader.feed(ByteView(all).subspan(at, count));
    at += count;
    for (std::string body; reader.next(body);) found.push_back(body);
  }
  RC_ASSERT(found == (std::vector<std::string>{"sRA a 1", "sSN b"}));
}

}  // namespace
}  // namespace scanbed::hw
