// SPDX-License-Identifier: MIT
#include "hw/sick/lms_reply.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "hw/sick/telegram.hpp"
#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;

const std::string kC34 = "00004600000001000002020000000A0A5064000A0A5064000A0A5064000000000200";

struct ReplyVector {
  LmsReply reply;
  std::string telegram;
  std::uint8_t address = 0x80;
  std::uint8_t status = 0x10;
};

std::vector<ReplyVector> reply_vectors() {
  const std::string text = "4C4D533230303B3330313036333B5630322E313020";
  const auto listed =
      LmsConfiguration::from_bytes(from_hex("0000700000000100000202" + std::string(42, '0') + "0200"));
  return {
      {ModeReply{0}, "02 80 03 00 A0 00 10 16 0A"},
      {ModeReply{0}, "02 81 03 00 A0 00 10 36 1A", 0x81},
      {ModeReply{1}, "02 80 03 00 A0 01 10 14 0B"},
      {ErrorsReply{}, "02 80 02 00 B2 10 3F 13"},
      {ErrorsReply{{{2, 17}}}, "02 80 04 00 B2 02 11 10 46 39"},
      {TypeReply{"LMS200;301063;V02.10 "}, "02 80 17 00 BA " + text + " 10 22 61"},
      {TypeReply{"LMS200;301063;V02.10 ", true}, "02 80 17 00 90 " + text + " 10 63 5E"},
      {TypeReply{"LMS200;301063;V02.06 ", true},
       "02 81 17 00 90 4C4D533230303B3330313036333B5630322E303620 13 64 5A", 0x81, 0x13},
      {VariantReply{true, {180, 50}}, "02 80 07 00 BB 01 B4 00 32 00 10 03 9D"},
      {VariantReply{false, {180, 50}}, "02 80 07 00 BB 00 B4 00 32 00 10 23 8D"},
      {ResetReply{}, "02 80 02 00 91 10 79 30"},
      {RefusedReply{}, "02 80 02 00 92 10 7F 33"},
      {ConfigurationReply{}, "02 80 24 00 F4 " + kC34 + " 10 00 29"},
      {WrittenReply{true, {}}, "02 80 25 00 F7 01 " + kC34 + " 10 F9 A8"},
      {WrittenReply{false, {}}, "02 80 25 00 F7 00 " + kC34 + " 10 59 F8"},
      {WrittenReply{true, *listed},
       "02 80 25 00 F7 01 0000700000000100000202" + std::string(42, '0') + "0200 10 C5 7A"},
  };
}

TEST(LmsReplyTest, EncodesEveryPrintedTelegram) {
  for (const ReplyVector& vector : reply_vectors()) {
    EXPECT_EQ(frame_telegram(vector.address, encode(vector.reply, {vector.status})),
              from_hex(vector.telegram))
        << vector.telegram;
  }
}

TEST(LmsReplyTest, ParsesEveryPrintedTelegram) {
  for (const ReplyVector& vector : reply_vectors()) {
    const Bytes body = encode(vector.reply, {vector.status});
    const auto stated = parse_reply(body);
    ASSERT_TRUE(stated.has_value()) << vector.telegram;
    EXPECT_EQ(stated->reply.index(), vector.reply.index());
    EXPECT_EQ(stated->status.bits, vector.status);
    EXPECT_EQ(encode(stated->reply, stated->status), body);
  }
}

TEST(LmsReplyTest, ReadsThePowerOnTextAndItsSeverity) {
  const auto stated = parse_reply(from_hex("90 4C4D533230303B3330313036333B5630322E303620 13"));
  ASSERT_TRUE(stated.has_value());
  const auto& reply = std::get<TypeReply>(stated->reply);
  EXPECT_TRUE(reply.is_power_on);
  EXPECT_EQ(reply.text, "LMS200;301063;V02.06 ");
  EXPECT_EQ(stated->status.severity(), 3);
}

TEST(LmsReplyTest, TheSensorsAccountOfItselfHasItsLengthAndOffsets) {
  StatusReply reply;
  reply.mode = LmsMode::kStream;
  reply.variant = {100, 25};
  reply.baud = 500000;
  reply.unit = RangeUnit::kCentimetre;
  reply.address = 1;
  reply.measuring_mode = 6;
  const Bytes body = encode(reply, {});
  ASSERT_EQ(body.size(), 0x9AU);
  EXPECT_EQ(body[8], 0x24);
  EXPECT_EQ(body[102], 6);
  EXPECT_EQ(read_word(body, 107), 100U);
  EXPECT_EQ(read_word(body, 109), 25U);
  EXPECT_EQ(read_word(body, 116), 0x8001U);
  EXPECT_EQ(body[120], 1);
  EXPECT_EQ(body[122], 0);
  const auto stated = parse_reply(body);
  ASSERT_TRUE(stated.has_value());
  const auto& parsed = std::get<StatusReply>(stated->reply);
  EXPECT_EQ(parsed.variant, reply.variant);
  EXPECT_EQ(parsed.baud, 500000);
  EXPECT_EQ(parsed.unit, RangeUnit::kCentimetre);
  EXPECT_EQ(parsed.firmware, "V02.10 ");
}

TEST(LmsReplyTest, BaudsHaveTheListingsCodes) {
  EXPECT_EQ(baud_code(9600), 0x8067U);
  EXPECT_EQ(baud_code(19200), 0x8033U);
  EXPECT_EQ(baud_code(38400), 0x8019U);
  EXPECT_EQ(baud_of_code(0x8001), 500000);
  EXPECT_EQ(baud_of_code(0x1234), 0);
}

TEST(LmsReplyTest, StatusByteSaysHowTheSensorIs) {
  const LmsStatusByte status{0xD2};
  EXPECT_EQ(status.severity(), 2);
  EXPECT_TRUE(status.is_polluted());
  EXPECT_TRUE(status.is_implausible());
  EXPECT_EQ(LmsStatusByte{0x10}.health(), SensorHealth{});
}

TEST(LmsReplyTest, RefusesWrongLengths) {
  for (const char* body : {"", "A0", "A0 10", "A0 00 00 10", "BB 01 B4 00 32 10", "B2 02 10", "F4 00 10",
                           "F7 10", "B1 00 10", "55 00"}) {
    EXPECT_FALSE(parse_reply(from_hex(body)).has_value()) << body;
  }
}

RC_GTEST_PROP(LmsReplyTest, TakesAnyBytes, (const Bytes& body)) {
  if (const auto stated = parse_reply(body)) RC_ASSERT(!encode(stated->reply, stated->status).empty());
}

}  // namespace
}  // namespace scanbed::hw
