// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <random>
#include <vector>

#include "hw/sick/sick_lms.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::tests {

/// Random faults, the slow ones seldom, with time between them to resume.
inline std::vector<hw::LmsFault> random_faults(int count, unsigned seed) {
  using Kind = hw::LmsFaultKind;
  const std::vector<Kind> quick = {Kind::kGarbage, Kind::kHalf, Kind::kFlip,     Kind::kBlindPair,
                                   Kind::kNak,     Kind::kMiss, Kind::kPollution};
  const std::vector<Kind> slow = {Kind::kSilence, Kind::kReboot, Kind::kUnplug};
  std::mt19937 chance(seed);
  std::vector<hw::LmsFault> faults;
  double at_s = 1.0;
  for (int i = 0; i < count; ++i) {
    const bool is_slow = i % 40 == 39;
    const std::vector<Kind>& kinds = is_slow ? slow : quick;
    faults.push_back({kinds[chance() % kinds.size()], at_s});
    at_s += is_slow ? 1.5 : 0.008;
  }
  return faults;
}

/// Streams through the faults: every scan that comes is a true one, later than the last, and the stream goes
/// on after the last fault.
inline void expect_to_survive(int num_faults, unsigned seed) {
  hw::EmulatorOptions sensor = quick_sensor();
  sensor.faults = random_faults(num_faults, seed);
  sensor.seed = seed;
  const std::filesystem::path link = ::testing::TempDir() + "soak_" + std::to_string(::getpid());
  RunningEmulator emulator(sensor, numbered_source(), {}, link);
  const hw::SickOptions options = quick_driver(emulator.port());
  hw::SickLms laser(options);
  LaserScan scan;
  std::int64_t last = -1;
  int num_after_end = 0;
  while (num_after_end < 200) {
    ASSERT_TRUE(laser.next(scan, RangeSensor::Seconds(30.0)));
    const auto number = number_of(scan);
    ASSERT_TRUE(number.has_value());
    ASSERT_GT(*number, last);
    last = *number;
    if (emulator.num_faults() == num_faults) ++num_after_end;
  }
  EXPECT_EQ(emulator.end().counts().num_faults, num_faults);
}

}  // namespace scanbed::tests
