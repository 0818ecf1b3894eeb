// SPDX-License-Identifier: MIT
#include "hw/sick/lms_session.hpp"

#include <gtest/gtest.h>

#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/least_time.hpp"
#include "tests/support/running_emulator.hpp"
#include "tests/support/scripted_port.hpp"

namespace scanbed::hw {
namespace {

using tests::patient_driver;
using tests::quick_driver;
using tests::quick_sensor;
using tests::RunningEmulator;

TEST(LmsSessionTest, TriesTheLastGoodBaudFirst) {
  EXPECT_EQ(probe_order(38400), (std::vector<int>{38400, 9600, 19200, 500000}));
  EXPECT_EQ(probe_order(9600), (std::vector<int>{9600, 38400, 19200, 500000}));
}

/// A busy machine may take longer for an answer than the quick driver waits, then it looks again.
LmsIdentity find_at_last(LmsLink& link) {
  for (const double end_s = steady_now_s() + 20.0; steady_now_s() < end_s;) {
    try {
      return find_lms(link, probe_order(38400));
    } catch (const SensorFault&) {
      continue;
    }
  }
  ADD_FAILURE() << "not found";
  return {};
}

TEST(LmsSessionTest, FindsTheSensorAtAnyBaud) {
  for (const int baud : kLmsBauds) {
    EmulatorOptions sensor = quick_sensor();
    sensor.power_on_baud = baud;
    RunningEmulator emulator(sensor);
    const StopSignal stop;
    SerialPort port(emulator.port());
    LmsLink link(port, quick_driver("").patience, stop);
    const LmsIdentity identity = find_at_last(link);
    EXPECT_EQ(identity.found_baud, baud);
    EXPECT_EQ(identity.status.baud, baud);
    EXPECT_EQ(identity.type, "LMS200;301063;V02.10 ");
    EXPECT_TRUE(identity.errors.empty());
  }
}

TEST(LmsSessionTest, StreamsAsTheOptionsSay) {
  EmulatorOptions sensor = quick_sensor();
  sensor.configuration.set_unit(RangeUnit::kCentimetre);
  RunningEmulator emulator(sensor);
  const StopSignal stop;
  SerialPort port(emulator.port());
  SickOptions options = patient_driver(emulator.port());
  options.resolution_cdeg = 100;
  LmsLink link(port, options.patience, stop);
  const LmsConfiguration configuration = start_stream(link, find_lms(link, probe_order(9600)), options);
  EXPECT_EQ(configuration.unit(), RangeUnit::kMillimetre);
  WireItem item;
  double arrival_s = 0.0;
  ASSERT_TRUE(link.next_telegram(item, 60.0, arrival_s));
  ScanTelegram scan;
  ASSERT_TRUE(parse_scan(item.body, scan));
  EXPECT_TRUE(matches(scan, {.variant = {180, 100}}));
  end_stream(port, 9600, 20.0);
  const EmulatedLms& lms = emulator.end();
  EXPECT_EQ(lms.mode(), LmsMode::kOnRequest);
  EXPECT_EQ(lms.baud(), 9600);
}

/// RS-232 as most machines have it, with nobody at it.
class PlainPort final : public ByteLink {
 public:
  std::size_t read(std::span<std::uint8_t> /*buffer*/, double /*timeout_s*/, const StopSignal&) override {
    return 0;
  }
  void write(ByteView /*bytes*/, const StopSignal&) override {}
  void flush_input() override {}
  void set_baud(int baud) override {
    if (baud > 115200) throw UnsupportedBaud("the port cannot do this baud");
  }
};

TEST(LmsSessionTest, PassesOverBaudsThatThePortCannotDo) {
  PlainPort port;
  const StopSignal stop;
  LmsLink link(port, quick_driver("").patience, stop);
  try {
    find_lms(link, probe_order(9600));
    ADD_FAILURE() << "found";
  } catch (const SensorFault& fault) {
    EXPECT_EQ(fault.kind(), SensorFault::Kind::kTimeout) << fault.what();
  }
}

TEST(LmsSessionTest, AsksASensorThatDidNotHearOnceMoreToStop) {
  const Bytes done = tests::from_hex("06 02 80 03 00 A0 00 10 16 0A");
  tests::ScriptedPort port;
  port.answers = {{kNotAcknowledge}, done, {}, done};
  end_stream(port, 9600, 0.05);
  ASSERT_EQ(port.requests.size(), 4U);
  EXPECT_EQ(port.requests[0], tests::from_hex("02 00 02 00 20 25 35 08"));
  EXPECT_EQ(port.requests[1], port.requests[0]);
  EXPECT_EQ(port.requests[3], port.requests[2]);
}

// A slow one may hear it all the same.
TEST(LmsSessionTest, AsksASensorThatDoesNotAnswerForItsBaudToo) {
  tests::ScriptedPort port;
  end_stream(port, 9600, 0.01);
  ASSERT_EQ(port.requests.size(), 3U);
  EXPECT_EQ(port.requests[2], tests::from_hex("02 00 02 00 20 42 52 08"));
}

TEST(LmsSessionTest, EndsSoonWhereNobodyListens) {
  PseudoTerminal nobody({});
  SerialPort port(nobody.path());
  EXPECT_LT(tests::least_seconds(0.2, [&] { end_stream(port, 9600, 0.07); }), 0.2);
}

}  // namespace
}  // namespace scanbed::hw
