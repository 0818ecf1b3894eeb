// SPDX-License-Identifier: MIT
#include "hw/serial/device_clock.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

TEST(DeviceClockTest, TheQuickestArrivalSetsTheOffset) {
  DeviceClock clock(24, 0.001);
  EXPECT_DOUBLE_EQ(clock.to_local_s(1000, 51.0), 51.0);
  // 20 ms late; drift is told apart from lateness at 0.1 ms a second.
  EXPECT_NEAR(clock.to_local_s(2000, 52.02), 52.0, 2e-4);
  // 5 ms quicker than the first: all of that is offset.
  EXPECT_NEAR(clock.to_local_s(3000, 52.995), 52.995, 1e-9);
  EXPECT_NEAR(clock.to_local_s(4000, 54.1), 53.995, 2e-4);
}

TEST(DeviceClockTest, GoesOnWhereTheCounterWraps) {
  DeviceClock clock(24, 0.001);
  EXPECT_DOUBLE_EQ(clock.to_local_s(16777215, 100.0), 100.0);
  EXPECT_NEAR(clock.to_local_s(0, 100.001), 100.001, 1e-6);
  DeviceClock wide(32, 1e-6);
  EXPECT_DOUBLE_EQ(wide.to_local_s(4294967295, 7.0), 7.0);
  EXPECT_NEAR(wide.to_local_s(999999, 8.0), 8.0, 1e-6);
}

TEST(DeviceClockTest, NeverGoesBackWhereTheFirstArrivalsWereLate) {
  DeviceClock clock(24, 0.001);
  EXPECT_DOUBLE_EQ(clock.to_local_s(0, 10.2), 10.2);  // 0.2 s late
  EXPECT_DOUBLE_EQ(clock.to_local_s(25, 10.225), 10.225);
  EXPECT_DOUBLE_EQ(clock.to_local_s(50, 10.225), 10.225);
  EXPECT_DOUBLE_EQ(clock.to_local_s(75, 10.226), 10.226);
  EXPECT_DOUBLE_EQ(clock.to_local_s(300, 10.3), 10.3);
  EXPECT_NEAR(clock.to_local_s(325, 10.35), 10.325, 1e-4);
}

TEST(DeviceClockTest, NeverIsLaterThanTheArrival) {
  DeviceClock clock(24, 0.001);
  for (int i = 0; i < 1000; ++i) {
    const double arrival_s = 10.0 + 0.025 * i + 0.003 * (i % 7);
    EXPECT_LE(clock.to_local_s(25 * i, arrival_s), arrival_s);
  }
}

}  // namespace
}  // namespace scanbed::hw
