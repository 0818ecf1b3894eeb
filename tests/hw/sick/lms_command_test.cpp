// SPDX-License-Identifier: MIT
#include "hw/sick/lms_command.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "hw/sick/telegram.hpp"
#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;
using What = RequestCommand::What;

struct CommandVector {
  LmsCommand command;
  const char* telegram;
};

// Telegrams as the manufacturer's listing prints them, or checked by four implementations of its CRC.
std::vector<CommandVector> command_vectors() {
  return {
      {SetModeCommand{LmsMode::kInstallation, true}, "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5"},
      {SetModeCommand{LmsMode::kTest, true}, "02 00 0A 00 20 30 53 49 43 4B 5F 4C 4D 53 EE F5"},
      {SetModeCommand{LmsMode::kDiagnostic}, "02 00 02 00 20 10 00 08"},
      {SetModeCommand{LmsMode::kStream}, "02 00 02 00 20 24 34 08"},
      {SetModeCommand{LmsMode::kOnRequest}, "02 00 02 00 20 25 35 08"},
      {SetModeCommand{LmsMode::kStreamPartial}, "02 00 02 00 20 2A 3A 08"},
      {SetBaudCommand{9600}, "02 00 02 00 20 42 52 08"},
      {SetBaudCommand{19200}, "02 00 02 00 20 41 51 08"},
      {SetBaudCommand{38400}, "02 00 02 00 20 40 50 08"},
      {SetBaudCommand{500000}, "02 00 02 00 20 48 58 08"},
      {StreamSubrangeCommand{27, 299}, "02 00 06 00 20 27 1B 00 2B 01 FF FE"},
      {RequestScanCommand{}, "02 00 02 00 30 01 31 18"},
      {RequestCommand{What::kStatus}, "02 00 01 00 31 15 12"},
      {RequestCommand{What::kErrors}, "02 00 01 00 32 16 12"},
      {RequestCommand{What::kType}, "02 00 01 00 3A 1E 12"},
      {RequestCommand{What::kConfiguration}, "02 00 01 00 74 50 12"},
      {RequestCommand{What::kOther}, "02 00 01 00 7B 5F 12"},
      {SetVariantCommand{{180, 50}}, "02 00 05 00 3B B4 00 32 00 3B 1F"},
      {SetVariantCommand{{180, 100}}, "02 00 05 00 3B B4 00 64 00 97 49"},
      {SetVariantCommand{{100, 25}}, "02 00 05 00 3B 64 00 19 00 E7 72"},
      {SetVariantCommand{{100, 50}}, "02 00 05 00 3B 64 00 32 00 B1 59"},
      {SetVariantCommand{{100, 100}}, "02 00 05 00 3B 64 00 64 00 1D 0F"},
      {ResetCommand{}, "02 00 01 00 10 34 12"},
      {SetPermanentBaudCommand{false}, "02 00 02 00 66 00 9C 4E"},
      {SetPermanentBaudCommand{true}, "02 00 02 00 66 01 9D 4E"},
      {WriteConfigurationCommand{},
       "02 00 23 00 77 00004600000001000002020000000A0A5064000A0A5064000A0A5064000000000200 0F E1"},
  };
}

TEST(LmsCommandTest, EncodesEveryPrintedTelegram) {
  for (const CommandVector& vector : command_vectors()) {
    EXPECT_EQ(frame_telegram(0x00, encode(vector.command)), from_hex(vector.telegram)) << vector.telegram;
  }
}

TEST(LmsCommandTest, ParsesEveryPrintedTelegram) {
  for (const CommandVector& vector : command_vectors()) {
    const Bytes body = encode(vector.command);
    const auto command = parse_command(body);
    ASSERT_TRUE(command.has_value()) << vector.telegram;
    EXPECT_EQ(command->index(), vector.command.index());
    EXPECT_EQ(encode(*command), body);
  }
}

TEST(LmsCommandTest, WritesTheListingsMillimetreConfiguration) {
  const Bytes bytes = from_hex("0000700000000100000202" + std::string(42, '0') + "0200");
  const auto configuration = LmsConfiguration::from_bytes(bytes);
  ASSERT_TRUE(configuration.has_value());
  const Bytes telegram = frame_telegram(0x00, encode(WriteConfigurationCommand{*configuration}));
  EXPECT_EQ(Bytes(telegram.end() - 2, telegram.end()), from_hex("11 88"));
}

TEST(LmsCommandTest, AWrongPasswordIsNone) {
  const auto command = parse_command(from_hex("20 00 53 49 43 B4 5F 4C 4D 53"));
  ASSERT_TRUE(command.has_value());
  EXPECT_FALSE(std::get<SetModeCommand>(*command).has_password);
  EXPECT_FALSE(std::get<SetModeCommand>(*parse_command(from_hex("20 00"))).has_password);
}

TEST(LmsCommandTest, RefusesWhatIsNoCommand) {
  for (const char* body : {"20 24 FF", "20 25 00", "20 40 40", "", "20", "20 99", "20 27 01", "30", "30 02",
                           "3B B4 00", "66", "66 02", "77", "99", "74 00"}) {
    EXPECT_FALSE(parse_command(from_hex(body)).has_value()) << body;
  }
}

RC_GTEST_PROP(LmsCommandTest, TakesAnyBytes, (const Bytes& body)) {
  if (const auto command = parse_command(body)) RC_ASSERT(!encode(*command).empty());
}

}  // namespace
}  // namespace scanbed::hw
