// SPDX-License-Identifier: MIT
#include "hw/recording/player_log.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

// Lines as Player's writelog printed them (five beams, 45 degrees apart).
const std::string kGeometry =
    "0000001000.000 16777343 6665 laser 00 004 001  +0.100  +0.000   0.000   0.150   0.150\n";
const std::string kScan =
    "0000002000.400 16777343 6665 laser 00 001 001 0001 -1.5708 +1.5708 +0.78539819 +8.0000 0005 1.000  1 "
    "1.500  2 "
    "8.000  0 0.000  0 -1.000 0\n";

TEST(PlayerLogTest, ReadsAScanAsPlayerWritesIt) {
  const Reading reading = read_all("## Player version 3.0.2\n" + kGeometry + kScan, "x");
  EXPECT_EQ(reading.error, "");
  ASSERT_EQ(reading.scans.size(), 1U);
  const LaserScan& scan = reading.scans[0];
  EXPECT_EQ(scan.time_s, 2000.4);
  EXPECT_EQ(scan.geometry.first_rad, -kPi / 2);
  EXPECT_EQ(scan.geometry.step_rad, kPi / 4);
  EXPECT_EQ(scan.geometry.max_range_m, 8.0);
  EXPECT_EQ(scan.range_m[0], 1.0);
  EXPECT_EQ(scan.range_m[1], 1.5);
  EXPECT_EQ(scan.range_m[2], kNoEcho);
  EXPECT_EQ(scan.range_m[3], kTooClose);
  EXPECT_TRUE(std::isnan(scan.range_m[4]));
  EXPECT_EQ(scan.source, "");
  EXPECT_EQ(reading.counts.num_other_lines, 2);
}

TEST(PlayerLogTest, APoseBecomesOdometryAndAnIndexASource) {
  const std::string posed =
      "0000000001.000 16777343 6665 laser 01 001 002 0001 +01.500 -02.000 +00.250 -1.5708 +1.5708 "
      "+3.14159265 +8.0000 "
      "0002 1.000  0 2.000  0\n";
  const Reading reading = read_all(posed, "x");
  ASSERT_EQ(reading.scans.size(), 1U) << reading.error;
  EXPECT_EQ(reading.scans[0].X_OR->p_m, Eigen::Vector2d(1.5, -2.0));
  EXPECT_EQ(reading.scans[0].X_OR->theta_rad, 0.25);
  EXPECT_EQ(reading.scans[0].source, "laser:1");
  EXPECT_EQ(read_all(posed + kScan, "x", {.only = "laser:1"}).scans.size(), 1U);
  EXPECT_EQ(read_all(posed + kScan, "x", {.only = "laser:0"}).scans.at(0).time_s, 2000.4);
}

TEST(PlayerLogTest, ReportsADamagedLineWithItsNumberAndReadsOn) {
  const std::string lacking = kScan.substr(0, kScan.size() - 3) + "\n";
  const std::string bad_number = "0000002000.400 16777343 6665 laser 00 001 001 0001 x 1 1 8 0\n";
  const std::string bad_prefix = "later 16777343 6665 laser 00 001 001\n";
  const std::string turn = "0000002000.400 16777343 6665 laser 00 001 001 0001 0 1 7 8 2 1 0 1 0\n";
  const Reading reading = read_all(kScan + lacking + bad_number + bad_prefix + turn + kScan, "x");
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(
      reading.reports,
      (std::vector<std::string>{
          "x:2: line skipped: laser: 5 readings announced, but 9 fields left on the line, two a reading",
          "x:3: line skipped: laser: min_angle is 'x', not a number",
          "x:4: line skipped: time is 'later', not a number",
          "x:5: line skipped: the beams are spread over more than a turn, in radians"}));
}

TEST(PlayerLogTest, ManyAnnouncedReadingsAreNotBelieved) {
  const Reading reading =
      read_all("0000002000.400 16777343 6665 laser 00 001 001 0001 0 1 0.1 8 2147483647 1 0\n" + kScan, "x");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.counts.num_damaged_lines, 1);
}

}  // namespace
}  // namespace scanbed::hw
