// SPDX-License-Identifier: MIT
#include "hw/sick/lms_link.hpp"

#include <gtest/gtest.h>

#include "hw/sick/scan_telegram.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/least_time.hpp"
#include "tests/support/scripted_port.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;
using tests::ScriptedPort;

class LmsLinkTest : public ::testing::Test {
 protected:
  ModeReply ask() { return link_.ask<ModeReply>(SetModeCommand{}); }

  ScriptedPort port_;
  StopSignal stop_;
  LmsLink link_{port_, {.ack_s = 0.05, .reply_s = 0.2}, stop_};
};

const char* const kAckAndDone = "06 02 80 03 00 A0 00 10 16 0A";

TEST_F(LmsLinkTest, GivesTheReply) {
  port_.answers = {from_hex(kAckAndDone)};
  EXPECT_EQ(ask().result, 0);
  EXPECT_EQ(port_.requests, std::vector<Bytes>{from_hex("02 00 02 00 20 25 35 08")});
}

TEST_F(LmsLinkTest, TakesAReplyWithoutAcknowledgement) {
  port_.answers = {from_hex("02 81 03 00 A0 00 10 36 1A")};
  EXPECT_EQ(ask().result, 0);
}

TEST_F(LmsLinkTest, AsksAgainAfterNakAndSilence) {
  port_.answers = {{kNotAcknowledge}, {}, from_hex(kAckAndDone)};
  EXPECT_EQ(ask().result, 0);
  EXPECT_EQ(port_.requests.size(), 3U);
}

TEST_F(LmsLinkTest, GivesUpInTheEnd) {
  EXPECT_THROW(ask(), SensorFault);
  EXPECT_EQ(port_.requests.size(), 3U);
  // Three times the patience for a first sign.
  EXPECT_LT(tests::least_seconds(0.3, [this] { EXPECT_THROW(ask(), SensorFault); }), 0.3);
}

TEST_F(LmsLinkTest, DoesNotAskAgainWhatWasRefused) {
  port_.answers = {from_hex("06 02 80 02 00 92 10 7F 33")};
  EXPECT_THROW(ask(), DeviceRefusal);
  EXPECT_EQ(port_.requests.size(), 1U);
}

TEST_F(LmsLinkTest, DropsOtherTelegramsBeforeTheReply) {
  Bytes answer = from_hex("02 80 0C 00 B0 04 40 E8 03 FE 1F FF 1F D0 27 10 F0 D5 02 80 02 00 B2 10 3F 13");
  const Bytes done = from_hex(kAckAndDone);
  answer.insert(answer.end(), done.begin(), done.end());
  port_.answers = {answer};
  EXPECT_EQ(ask().result, 0);
}

TEST_F(LmsLinkTest, NoticesAReboot) {
  port_.answers = {from_hex("02 80 17 00 90 4C4D533230303B3330313036333B5630322E313020 10 63 5E")};
  EXPECT_THROW(ask(), LmsReboot);
}

TEST_F(LmsLinkTest, AcknowledgementsInsideGarbageDoNotHoldItUp) {
  Bytes garbage;
  for (int i = 0; i < 400; ++i) garbage.push_back(static_cast<std::uint8_t>(i % 50 == 0 ? 0x06 : 0xAA));
  const double least_s = tests::least_seconds(3 * 0.2, [&] {
    port_.answers = {garbage, garbage, garbage};
    EXPECT_THROW(ask(), SensorFault);
  });
  EXPECT_LT(least_s, 3 * 0.2);
}

// After a while in which nobody read, the port gives what came in pieces of its own size.
TEST_F(LmsLinkTest, TellsHowMuchStandsBehindATelegram) {
  const Bytes scan = frame_telegram(0x80, encode(ScanTelegram{.words = std::vector<std::uint16_t>(361)}));
  Bytes& scans = port_.answers.emplace_back();
  for (int i = 0; i < 30; ++i) scans.insert(scans.end(), scan.begin(), scan.end());
  link_.tell(SetModeCommand{LmsMode::kStream});
  WireItem item;
  double arrival_s = 0.0;
  for (std::size_t num_left = 30; num_left-- > 0;) {
    ASSERT_TRUE(link_.next_telegram(item, 1.0, arrival_s));
    EXPECT_EQ(item.num_bytes_behind, num_left * scan.size());
  }
}

TEST_F(LmsLinkTest, StopsAtOnce) {
  stop_.give();
  EXPECT_THROW(ask(), Stopped);
}

}  // namespace
}  // namespace scanbed::hw
