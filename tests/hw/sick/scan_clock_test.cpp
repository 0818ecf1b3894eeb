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
  EXPECT_NEAR(clock.first_beam_s({100.0}, 732, geometry), 100.0 - wire_s - scan_s, 1e-4);
}

TEST(ScanClockTest, NeverGoesBack) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(500000);
  const double first_s = clock.first_beam_s({5.0}, 732, geometry);
  EXPECT_EQ(clock.first_beam_s({4.9}, 732, geometry), first_s);
  EXPECT_GT(clock.first_beam_s({5.1}, 732, geometry), first_s);
}

constexpr double kPeriod_s = 2 * 0.01332;

TEST(ScanClockTest, TelegramsReadTogetherAreAPeriodApart) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(500000);
  clock.first_beam_s({9.0}, 732, geometry);
  const double first_s = clock.first_beam_s({10.0, 2 * 732 + 100}, 732, geometry);
  const double second_s = clock.first_beam_s({10.0, 732 + 100}, 732, geometry);
  const double third_s = clock.first_beam_s({10.0, 100}, 732, geometry);
  // A hundred bytes came after it.
  EXPECT_NEAR(third_s, ScanClock(500000).first_beam_s({10.0 - 1000.0 / 500000.0}, 732, geometry), 1e-9);
  EXPECT_NEAR(third_s - second_s, kPeriod_s, 1e-9);
  EXPECT_NEAR(second_s - first_s, kPeriod_s, 1e-9);
}

// At 38400 baud that is longer than the scan.
TEST(ScanClockTest, TelegramsReadTogetherAreAWireTimeApart) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(38400);
  const double first_s = clock.first_beam_s({10.0, 732}, 732, geometry);
  EXPECT_NEAR(clock.first_beam_s({10.0}, 732, geometry) - first_s, 7320.0 / 38400.0, 1e-9);
}

// As where garbage before it looked like the head of a telegram, and it was found only after its time.
TEST(ScanClockTest, WhatStandsBehindATelegramCameAfterIt) {
  const ScanGeometry geometry = sick_geometry({}, {});
  const double at_once_s = ScanClock(38400).first_beam_s({10.0}, 732, geometry);
  for (const std::size_t num_bytes_behind : {100, 300, 700}) {
    const double delay_s = static_cast<double>(num_bytes_behind) * 10.0 / 38400.0;
    EXPECT_NEAR(ScanClock(38400).first_beam_s({10.0 + delay_s, num_bytes_behind}, 732, geometry), at_once_s,
                1e-9);
  }
}

TEST(ScanClockTest, TelegramsReadTogetherShareWhatTimeThereWas) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(500000);
  double last_s = clock.first_beam_s({10.0}, 732, geometry);
  for (const std::size_t num_behind : {2, 1, 0}) {
    const double next_s = clock.first_beam_s({10.03, num_behind * 732}, 732, geometry);
    EXPECT_NEAR(next_s - last_s, 0.01, 1e-9);
    last_s = next_s;
  }
}

TEST(ScanClockTest, ScansOfASensorThatIsNotPacedAreAsFarApartAsOfOneThatIs) {
  const ScanGeometry geometry = sick_geometry({}, {});
  for (const auto& [baud, period_s] : {std::pair(38400, 7320.0 / 38400.0), {500000, kPeriod_s}}) {
    ScanClock clock(baud, false);
    double last_s = clock.first_beam_s({10.0, 732}, 732, geometry);
    for (const double read_s : {10.0, 10.001, 10.002}) {
      const double next_s = clock.first_beam_s({read_s, 732}, 732, geometry);
      EXPECT_NEAR(next_s - last_s, period_s, 1e-9);
      last_s = next_s;
    }
    // One that is slower than it could be has the time on the wall.
    EXPECT_EQ(clock.first_beam_s({20.0}, 732, geometry), ScanClock(baud).first_beam_s({20.0}, 732, geometry));
  }
}

TEST(ScanClockTest, TelegramsReadTogetherAtTheStartAreNotFromBefore) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(9600);
  const double wire_and_scan_s = 7320.0 / 9600.0 + kPeriod_s;
  double last_s = 0.0;
  for (const std::size_t num_behind : {2, 1, 0}) {
    const double next_s = clock.first_beam_s({wire_and_scan_s, num_behind * 732}, 732, geometry);
    EXPECT_GT(next_s, last_s);
    last_s = next_s;
  }
}

// An emulator's pseudo-terminal carries them as fast as they are written: what is behind a telegram would
// have taken longer than there was time for.
TEST(ScanClockTest, ALinkThatIsFasterThanItsBaudGivesEachScanALaterTime) {
  const ScanGeometry geometry = sick_geometry({}, {});
  ScanClock clock(9600);
  double read_s = 7320.0 / 9600.0 + kPeriod_s;
  double last_s = 0.0;
  for (const std::size_t num_bytes_behind : {700, 0, 731, 300, 0, 1}) {
    const double next_s = clock.first_beam_s({read_s, num_bytes_behind}, 732, geometry);
    EXPECT_GT(next_s, last_s) << num_bytes_behind;
    last_s = next_s;
    read_s += 0.002;
  }
}

}  // namespace
}  // namespace scanbed::hw
