// SPDX-License-Identifier: MIT
#include "hw/sick/emulated_lms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/support/hex.hpp"
#include "tests/support/numbered_sensor.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;
using tests::numbered_source;

/// An emulated sensor in a time of its own.
class Bench {
 public:
  explicit Bench(const EmulatorOptions& options = {}) : lms(options, numbered_source(), {}) {}

  /// Sends a request and collects what comes back within `wait_s`.
  Bytes ask(ByteView telegram, double wait_s = 0.5) {
    lms.receive(telegram, host_baud, now_s);
    return wait(wait_s);
  }
  Bytes ask(const LmsCommand& command, double wait_s = 0.5) {
    return ask(frame_telegram(0, encode(command)), wait_s);
  }

  Bytes wait(double wait_s) {
    Bytes out;
    for (const double end_s = now_s + wait_s; now_s < end_s; now_s += 0.001) lms.run(now_s, host_baud, out);
    return out;
  }

  EmulatedLms lms;
  int host_baud = 9600;
  double now_s = 100.0;
};

Bytes with_ack(std::string_view telegram) {
  Bytes bytes = from_hex(telegram);
  bytes.insert(bytes.begin(), kAcknowledge);
  return bytes;
}

const char* const kDone = "02 80 03 00 A0 00 10 16 0A";

std::vector<ScanTelegram> scans_in(ByteView bytes) {
  TelegramDecoder decoder(TelegramDecoder::Talker::kSensor);
  decoder.feed(bytes, 0.0);
  std::vector<ScanTelegram> scans;
  for (WireItem item; decoder.next(item);) {
    ScanTelegram scan;
    if (item.kind == WireItem::Kind::kTelegram && parse_scan(item.body, scan)) scans.push_back(scan);
  }
  return scans;
}

std::optional<LmsReply> reply_in(ByteView bytes) {
  TelegramDecoder decoder(TelegramDecoder::Talker::kSensor);
  decoder.feed(bytes, 0.0);
  for (WireItem item; decoder.next(item);) {
    if (item.kind != WireItem::Kind::kTelegram) continue;
    if (const auto stated = parse_reply(item.body)) return stated->reply;
  }
  return std::nullopt;
}

TEST(EmulatedLmsTest, AnswersAsPrinted) {
  Bench bench;
  EXPECT_EQ(bench.ask(from_hex("02 00 02 00 20 25 35 08")), with_ack(kDone));
  EXPECT_EQ(bench.ask(from_hex("02 00 01 00 32 16 12")), with_ack("02 80 02 00 B2 10 3F 13"));
  EXPECT_EQ(bench.ask(from_hex("02 00 01 00 3A 1E 12")),
            with_ack("02 80 17 00 BA 4C4D533230303B3330313036333B5630322E313020 10 22 61"));
  EXPECT_EQ(bench.ask(from_hex("02 00 05 00 3B B4 00 32 00 3B 1F")),
            with_ack("02 80 07 00 BB 01 B4 00 32 00 10 03 9D"));
  EXPECT_EQ(
      bench.ask(from_hex("02 00 01 00 74 50 12")),
      with_ack(
          "02 80 24 00 F4 00004600000001000002020000000A0A5064000A0A5064000A0A5064000000000200 10 00 29"));
  EXPECT_EQ(bench.ask(from_hex("02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5")), with_ack(kDone));
}

TEST(EmulatedLmsTest, RefusesAQuarterDegreeAt180) {
  Bench bench;
  EXPECT_EQ(bench.ask(SetVariantCommand{{180, 25}}), with_ack("02 80 07 00 BB 00 B4 00 32 00 10 23 8D"));
}

TEST(EmulatedLmsTest, WantsThePassword) {
  Bench bench;
  EXPECT_EQ(bench.ask(SetModeCommand{LmsMode::kInstallation}), with_ack("02 80 03 00 A0 01 10 14 0B"));
  EXPECT_EQ(bench.lms.mode(), LmsMode::kOnRequest);
  bench.ask(SetModeCommand{LmsMode::kInstallation, true});
  EXPECT_EQ(bench.lms.mode(), LmsMode::kInstallation);
}

TEST(EmulatedLmsTest, WritesItsConfigurationInInstallationModeAlone) {
  Bench bench;
  LmsConfiguration wanted;
  wanted.set_unit(RangeUnit::kCentimetre);
  EXPECT_EQ(bench.ask(WriteConfigurationCommand{wanted}), with_ack("02 80 02 00 92 10 7F 33"));
  bench.ask(SetModeCommand{LmsMode::kInstallation, true});
  const auto written = reply_in(bench.ask(WriteConfigurationCommand{wanted}));
  EXPECT_TRUE(std::get<WrittenReply>(*written).is_done);
  wanted.set_measuring_mode(0x55);
  const auto refused = reply_in(bench.ask(WriteConfigurationCommand{wanted}));
  EXPECT_FALSE(std::get<WrittenReply>(*refused).is_done);
  EXPECT_EQ(std::get<WrittenReply>(*refused).configuration.measuring_mode(), 0);
  EXPECT_EQ(bench.lms.counts().num_eeprom_writes, 1);
}

TEST(EmulatedLmsTest, GivesAScanOnRequestInInstallationModeToo) {
  Bench bench;
  bench.ask(SetModeCommand{LmsMode::kInstallation, true});
  EXPECT_EQ(scans_in(bench.ask(RequestScanCommand{}, 1.0)).size(), 1U);
  EXPECT_EQ(bench.lms.mode(), LmsMode::kInstallation);
}

TEST(EmulatedLmsTest, HearsItsOwnAddressAndTheBroadcastAlone) {
  Bench bench({.address = 1});
  const Bytes body = encode(SetModeCommand{LmsMode::kOnRequest});
  EXPECT_EQ(bench.ask(frame_telegram(0x02, body)), Bytes{});
  EXPECT_EQ(bench.ask(frame_telegram(0x01, body)), with_ack("02 81 03 00 A0 00 10 36 1A"));
  EXPECT_EQ(bench.ask(frame_telegram(0x00, body)), with_ack("02 81 03 00 A0 00 10 36 1A"));
}

TEST(EmulatedLmsTest, SaysNakToADamagedRequestAnd92hToAnUnknownOne) {
  Bench bench;
  EXPECT_EQ(bench.ask(from_hex("02 00 02 00 20 25 35 09")), Bytes{kNotAcknowledge});
  for (const char* unknown : {"55", "99", "20 99"}) {
    EXPECT_EQ(bench.ask(frame_telegram(0, from_hex(unknown))), with_ack("02 80 02 00 92 10 7F 33"))
        << unknown;
  }
}

TEST(EmulatedLmsTest, ChangesItsBaudAfterTheReply) {
  Bench bench;
  EXPECT_EQ(bench.ask(SetBaudCommand{38400}), with_ack(kDone));
  EXPECT_EQ(bench.lms.baud(), 38400);
  EXPECT_EQ(bench.ask(SetModeCommand{LmsMode::kOnRequest}), Bytes{});  // the host still at 9600
  bench.host_baud = 38400;
  EXPECT_EQ(bench.ask(SetModeCommand{LmsMode::kOnRequest}), with_ack(kDone));
}

TEST(EmulatedLmsTest, AHostAtAnotherBaudReadsGibberish) {
  Bench bench;
  bench.ask(SetModeCommand{LmsMode::kStream});
  bench.host_baud = 38400;
  const Bytes bytes = bench.wait(5.0);
  EXPECT_GT(bytes.size(), 1000U);
  EXPECT_TRUE(scans_in(bytes).empty());
}

TEST(EmulatedLmsTest, StartsAnewAfterAReset) {
  Bench bench;
  bench.ask(SetBaudCommand{38400});
  bench.host_baud = 38400;
  bench.ask(SetModeCommand{LmsMode::kTest, true});
  const auto reset = reply_in(bench.ask(from_hex("02 00 01 00 10 34 12")));
  EXPECT_TRUE(std::holds_alternative<ResetReply>(*reset));
  EXPECT_EQ(bench.ask(SetModeCommand{LmsMode::kOnRequest}), Bytes{});  // it boots
  bench.host_baud = 9600;
  EXPECT_EQ(bench.wait(3.0), from_hex("02 80 17 00 90 4C4D533230303B3330313036333B5630322E313020 10 63 5E"));
  EXPECT_EQ(bench.lms.mode(), LmsMode::kOnRequest);
}

TEST(EmulatedLmsTest, KeepsAPermanentBaud) {
  Bench bench;
  bench.ask(SetBaudCommand{38400});
  bench.host_baud = 38400;
  EXPECT_TRUE(std::holds_alternative<RefusedReply>(*reply_in(bench.ask(SetPermanentBaudCommand{true}))));
  bench.ask(SetModeCommand{LmsMode::kInstallation, true});
  bench.ask(SetPermanentBaudCommand{true});
  bench.ask(ResetCommand{}, 3.0);
  EXPECT_EQ(bench.lms.baud(), 38400);
}

TEST(EmulatedLmsTest, TellsAboutItself) {
  Bench bench;
  bench.ask(SetVariantCommand{{100, 25}});
  const auto reply = reply_in(bench.ask(RequestCommand{}));
  const auto& status = std::get<StatusReply>(*reply);
  EXPECT_EQ(status.variant, (LmsVariant{100, 25}));
  EXPECT_EQ(status.baud, 9600);
  EXPECT_EQ(status.mode, LmsMode::kOnRequest);
}

TEST(EmulatedLmsTest, GivesOneScanOnRequest) {
  Bench bench;
  const auto scans = scans_in(bench.ask(from_hex("02 00 02 00 30 01 31 18"), 1.0));
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(scans[0].words.size(), 361U);
  EXPECT_EQ(scans[0].words[5], tests::numbered_steps(0, 5));
}

TEST(EmulatedLmsTest, GivesFourTurnsOnRequest) {
  Bench bench;
  const auto turns = scans_in(bench.ask(RequestScanCommand{RequestScanCommand::What::kPartials}, 3.0));
  ASSERT_EQ(turns.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const ScanTelegram& turn = turns[static_cast<std::size_t>(i)];
    EXPECT_EQ(turn.partial, i);
    EXPECT_EQ(static_cast<int>(turn.words.size()), partial_size(i));
    EXPECT_EQ(turn.words[10], tests::numbered_steps(0, 40 + i));
  }
}

// Scans left out between two that are sent, by the manufacturer's table: 29, 15, 8 and 0 of 26.64 ms each.
TEST(EmulatedLmsTest, StreamsAtTheRateOfTheLink) {
  for (const auto& [baud, num_left_out] : {std::pair{9600, 29}, {19200, 15}, {38400, 8}, {500000, 0}}) {
    Bench bench;
    if (baud != 9600) bench.ask(SetBaudCommand{baud});
    bench.host_baud = baud;
    bench.ask(SetModeCommand{LmsMode::kStream}, 0.1);
    const double period_s = (num_left_out + 1) * 0.02664;
    const auto scans = scans_in(bench.wait(20.0 * period_s));
    EXPECT_NEAR(static_cast<double>(scans.size()), 20.0, 1.0) << baud;
  }
}

TEST(EmulatedLmsTest, ARequestBreaksTheStreamOff) {
  Bench bench;
  bench.ask(SetModeCommand{LmsMode::kStream}, 0.5);
  const Bytes rest = bench.ask(SetModeCommand{LmsMode::kOnRequest}, 2.0);
  EXPECT_EQ(rest, with_ack(kDone));
}

TEST(EmulatedLmsTest, FaultsComeAtTheirTime) {
  EmulatorOptions options;
  options.faults = {{LmsFaultKind::kNak, 2.0}, {LmsFaultKind::kMiss, 1.0}};
  Bench bench(options);
  EXPECT_EQ(bench.ask(SetModeCommand{}, 1.1), with_ack(kDone));
  EXPECT_EQ(bench.ask(SetModeCommand{}, 1.0), Bytes{});
  EXPECT_EQ(bench.ask(SetModeCommand{}), Bytes{kNotAcknowledge});
  EXPECT_EQ(bench.ask(SetModeCommand{}), with_ack(kDone));
  EXPECT_EQ(bench.lms.counts().num_faults, 2);
}

TEST(EmulatedLmsTest, SleepsUntilThereIsSomethingToDo) {
  Bench bench;
  bench.wait(0.01);
  EXPECT_TRUE(std::isinf(bench.lms.next_event_s()));
  bench.lms.receive(frame_telegram(0, encode(SetModeCommand{LmsMode::kStream})), 9600, bench.now_s);
  EXPECT_LT(bench.lms.next_event_s(), bench.now_s + 0.1);
}

}  // namespace
}  // namespace scanbed::hw
