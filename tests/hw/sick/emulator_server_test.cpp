// SPDX-License-Identifier: MIT
#include "hw/sick/emulator_server.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/sick/lms_command.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/least_time.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::hw {
namespace {

using tests::RunningEmulator;

/// Reads until `count` bytes are there, however busy the machine is, and what comes with them.
Bytes read_bytes(SerialPort& port, std::size_t count) {
  const StopSignal stop;
  Bytes all;
  std::array<std::uint8_t, 1024> buffer{};
  for (const double end_s = steady_now_s() + 20.0; all.size() < count && steady_now_s() < end_s;) {
    const std::size_t num_read = port.read(buffer, 0.05, stop);
    all.insert(all.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(num_read));
  }
  return all;
}

void ask_for_request_mode(SerialPort& port) {
  port.write(frame_telegram(0, encode(SetModeCommand{})), StopSignal());
}

TEST(EmulatorServerTest, AnswersAtThePortBehindTheLink) {
  const std::filesystem::path link = ::testing::TempDir() + "emulated_" + std::to_string(::getpid());
  RunningEmulator emulator({}, tests::numbered_source(), {}, link);
  EXPECT_EQ(emulator.port(), link.string());
  SerialPort port(link.string());
  ask_for_request_mode(port);
  const Bytes expected = tests::from_hex("06 02 80 03 00 A0 00 10 16 0A");
  EXPECT_EQ(read_bytes(port, expected.size()), expected);
}

TEST(EmulatorServerTest, HearsNothingAtAnotherBaud) {
  RunningEmulator emulator({});
  SerialPort port(emulator.port());
  port.set_baud(38400);
  ask_for_request_mode(port);
  std::array<std::uint8_t, 16> buffer{};
  EXPECT_EQ(port.read(buffer, 0.3, StopSignal()), 0U);
}

TEST(EmulatorServerTest, StopsAtOnce) {
  EXPECT_LT(tests::least_seconds(0.2, [] { RunningEmulator emulator({}); }), 0.2);
}

TEST(EmulatorServerTest, ObserversSeeScansBeforeTheyAreSent) {
  std::vector<std::int64_t> numbers;
  const auto observer = [&](const SentScan& sent) { numbers.push_back(sent.number); };
  RunningEmulator emulator(tests::quick_sensor(), tests::numbered_source(), observer);
  SerialPort port(emulator.port());
  const StopSignal stop;
  port.write(frame_telegram(0, encode(RequestScanCommand{})), stop);
  EXPECT_EQ(read_bytes(port, 733).size(), 733U);  // ACK and the scan
  emulator.end();
  EXPECT_EQ(numbers, std::vector<std::int64_t>{0});
}

}  // namespace
}  // namespace scanbed::hw
