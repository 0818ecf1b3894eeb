// SPDX-License-Identifier: MIT
#include "hw/sick/emulator_server.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/sick/lms_command.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::hw {
namespace {

using tests::RunningEmulator;

Bytes read_for(SerialPort& port, double duration_s) {
  const StopSignal stop;
  Bytes all;
  std::array<std::uint8_t, 1024> buffer{};
  for (const double end_s = steady_now_s() + duration_s; steady_now_s() < end_s;) {
    const std::size_t count = port.read(buffer, 0.05, stop);
    all.insert(all.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return all;
}

TEST(EmulatorServerTest, AnswersAtThePortBehindTheLink) {
  const std::filesystem::path link = ::testing::TempDir() + "emulated_" + std::to_string(::getpid());
  RunningEmulator emulator({}, tests::numbered_source(), {}, link);
  EXPECT_EQ(emulator.port(), link.string());
  SerialPort port(link.string());
  const StopSignal stop;
  port.write(frame_telegram(0, encode(SetModeCommand{})), stop);
  Bytes expected = tests::from_hex("06 02 80 03 00 A0 00 10 16 0A");
  EXPECT_EQ(read_for(port, 0.6), expected);
}

TEST(EmulatorServerTest, HearsNothingAtAnotherBaud) {
  RunningEmulator emulator({});
  SerialPort port(emulator.port());
  port.set_baud(38400);
  const StopSignal stop;
  port.write(frame_telegram(0, encode(SetModeCommand{})), stop);
  EXPECT_TRUE(read_for(port, 0.3).empty());
}

TEST(EmulatorServerTest, StopsAtOnce) {
  const double start_s = steady_now_s();
  { RunningEmulator emulator({}); }
  EXPECT_LT(steady_now_s() - start_s, 0.3);
}

TEST(EmulatorServerTest, ObserversSeeScansBeforeTheyAreSent) {
  std::vector<std::int64_t> numbers;
  const auto observer = [&](const SentScan& sent) { numbers.push_back(sent.number); };
  RunningEmulator emulator(tests::quick_sensor(), tests::numbered_source(), observer);
  SerialPort port(emulator.port());
  const StopSignal stop;
  port.write(frame_telegram(0, encode(RequestScanCommand{})), stop);
  EXPECT_GT(read_for(port, 0.3).size(), 700U);
  emulator.end();
  EXPECT_EQ(numbers, std::vector<std::int64_t>{0});
}

}  // namespace
}  // namespace scanbed::hw
