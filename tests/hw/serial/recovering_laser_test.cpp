// SPDX-License-Identifier: MIT
#include "hw/serial/recovering_laser.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/support/least_time.hpp"

namespace scanbed::hw {
namespace {

using Seconds = RangeSensor::Seconds;
constexpr Seconds kPatience{20.0};

RecoveringLaser laser_of(RecoveringLaser::Attempt attempt, RecoveryOptions options = {.pause_s = 0.01}) {
  return RecoveringLaser("device", options, std::move(attempt));
}

TEST(RecoveringLaserTest, AttemptsAgainAfterAFault) {
  int num_attempts = 0;
  auto laser = laser_of([&](const RecoveringLaser::Give& give, const StopSignal&) {
    LaserScan scan;
    scan.range_m = {static_cast<double>(++num_attempts)};
    give(scan);
    throw SensorFault(SensorFault::Kind::kDisconnected, "unplugged");
  });
  LaserScan scan;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    EXPECT_EQ(scan.index, i);
    EXPECT_EQ(scan.range_m[0], i + 1.0);
  }
}

TEST(RecoveringLaserTest, GivesUpWhereItNeverBegan) {
  auto laser = laser_of([](const RecoveringLaser::Give&, const StopSignal&) {
    throw SensorFault(SensorFault::Kind::kTimeout, "nothing answers");
  });
  LaserScan scan;
  for (int i = 0; i < 2; ++i) {
    try {
      laser.next(scan, kPatience);
      FAIL();
    } catch (const SensorFault& fault) {
      // No timeout: asking again would not help.
      EXPECT_EQ(fault.kind(), SensorFault::Kind::kDisconnected);
      EXPECT_TRUE(std::string(fault.what()).ends_with(": nothing answers")) << fault.what();
    }
  }
}

TEST(RecoveringLaserTest, ARefusalIsTheEnd) {
  int num_attempts = 0;
  auto laser = laser_of([&](const RecoveringLaser::Give&, const StopSignal&) {
    ++num_attempts;
    throw DeviceRefusal("no");
  });
  LaserScan scan;
  EXPECT_THROW(laser.next(scan, kPatience), DeviceRefusal);
  EXPECT_EQ(num_attempts, 1);
}

TEST(RecoveringLaserTest, TimesOutAndStopsAtOnce) {
  const auto time_out_and_stop = [] {
    auto laser = laser_of([](const RecoveringLaser::Give&, const StopSignal& stop) { stop.sleep(100.0); });
    LaserScan scan;
    try {
      laser.next(scan, Seconds(0.05));
      FAIL();
    } catch (const SensorFault& fault) {
      EXPECT_EQ(fault.kind(), SensorFault::Kind::kTimeout);
    }
  };
  EXPECT_LT(tests::least_seconds(0.2, time_out_and_stop), 0.2);
}

}  // namespace
}  // namespace scanbed::hw
