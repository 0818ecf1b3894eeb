// SPDX-License-Identifier: MIT
#include "hw/sick/scan_clock.hpp"

#include <gtest/gtest.h>

#include "hw/sick/sick_options.hpp"

namespace scanbed::hw {
namespace {

TEST(ScanClockTest, TakesOffTheWireAndTheScan) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(38400);
  // 732 bytes of ten bits; the second of two turns ends half a turn after it begins.
  const double wire_s = 7320.0 / 38400.0;
  const double scan_s = 1.5 * 0.01332;
  EXPECT_NEAR(clock.first_beam_s(100.0, 732, geometry), 100.0 - wire_s - scan_s, 1e-4);
}

TEST(ScanClockTest, NeverGoesBack) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(500000);
  const double first_s = clock.first_beam_s(5.0, 732, geometry);
  EXPECT_EQ(clock.first_beam_s(4.9, 732, geometry), first_s);
  EXPECT_GT(clock.first_beam_s(5.1, 732, geometry), first_s);
}

}  // namespace
}  // namespace scanbed::hw
