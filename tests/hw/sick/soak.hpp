// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <map>
#include <random>
#include <string>

#include "hw/sick/sick_lms.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::tests {

/// Draws faults, the slow ones seldom.
class FaultDice {
 public:
  explicit FaultDice(unsigned seed) : chance_(seed) {}

  hw::LmsFaultKind next() {
    using Kind = hw::LmsFaultKind;
    constexpr std::array kQuick = {Kind::kGarbage, Kind::kHalf, Kind::kFlip,     Kind::kBlindPair,
                                   Kind::kNak,     Kind::kMiss, Kind::kPollution};
    constexpr std::array kSlow = {Kind::kSilence, Kind::kReboot, Kind::kUnplug};
    if (++num_drawn_ % 40 == 0) return kSlow.at(chance_() % kSlow.size());
    return kQuick.at(chance_() % kQuick.size());
  }

 private:
  std::mt19937 chance_;
  int num_drawn_ = 0;
};

/// Streams through random faults, the next one as soon as scans that were sent after the last one have
/// arrived: so the stream resumes after each. Every scan that comes is a true one, later than the last.
inline void expect_to_survive(int num_faults, unsigned seed) {
  hw::EmulatorOptions sensor = quick_sensor();
  sensor.seed = seed;
  FaultDice dice(seed);
  std::map<std::string, int> num_of_kind;
  std::atomic<std::int64_t> last_arrived{-1};
  std::atomic<int> num_injected{0};
  std::atomic<std::int64_t> last_fault{-1};  // the scan sent just before
  std::atomic<RunningEmulator*> running{nullptr};
  const auto inject = [&](const hw::SentScan& sent) {
    if (num_injected == num_faults || last_arrived < last_fault + 3) return;
    const hw::LmsFaultKind fault = dice.next();
    running.load()->lms().inject(fault);
    last_fault = sent.scan.index;
    ++num_injected;
    ++num_of_kind[std::string(hw::to_string(fault))];
  };
  const std::filesystem::path link = ::testing::TempDir() + "soak_" + std::to_string(::getpid());
  RunningEmulator emulator(sensor, numbered_source(), inject, link);
  running = &emulator;
  hw::SickLms laser(quick_driver(emulator.port()));
  LaserScan scan;
  std::int64_t num_scans = 0;
  while (num_injected < num_faults || last_arrived < last_fault + 100) {
    // Generous: the machine may be busy with other things.
    ASSERT_TRUE(laser.next(scan, RangeSensor::Seconds(300.0)));
    const auto number = number_of(scan);
    ASSERT_TRUE(number.has_value());
    ASSERT_GT(*number, last_arrived.load());
    last_arrived = *number;
    ++num_scans;
  }
  EXPECT_EQ(emulator.end().counts().num_faults, num_faults);
  std::printf("%lld scans through", static_cast<long long>(num_scans));
  for (const auto& [kind, count] : num_of_kind) std::printf(" %d %s", count, kind.c_str());
  const hw::SickReport report = laser.report();
  std::printf("; %lld CRC errors, %lld telegrams refused, %lld restarts\n",
              static_cast<long long>(report.num_crc_errors),
              static_cast<long long>(report.num_refused_telegrams),
              static_cast<long long>(report.num_restarts));
}

}  // namespace scanbed::tests
