// SPDX-License-Identifier: MIT
#include "hw/recording/player_writer.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

// As in the format's description: geometry first, then the scan.
TEST(PlayerWriterTest, WritesTheFieldsAsPlayerPrintsThem) {
  LaserScan scan;
  scan.geometry = {.num_beams = 5, .first_rad = -kPi / 2, .step_rad = kPi / 4, .max_range_m = 8.0};
  scan.range_m = {1.0, 1.5, kNoEcho, kTooClose, 0.0005};
  scan.time_s = 2000.4;
  const std::string log = recorded("x.player", {scan});
  EXPECT_NE(log.find("\n0000002000.400 16777343 6665 laser 00 004 001 +0.000 +0.000 +0.000 +0.150 +0.150\n"),
            std::string::npos)
      << log;
  EXPECT_NE(
      log.find(
          "\n0000002000.400 16777343 6665 laser 00 001 001 0000 -1.5708 +1.5708 +0.78539816 +8.0000 0005 "
          "1.000  0 1.500  0 8.000  0 0.000  0 0.001  0\n"),
      std::string::npos)
      << log;
}

// Rounded to millimetres 8.1816 is beyond 8.1815.
TEST(PlayerWriterTest, ARangeAtTheLimitIsStillARange) {
  LaserScan scan = made_scan(1);
  scan.geometry.max_range_m = 8.1817;
  scan.range_m[0] = 8.1816;
  const Reading reading = read_all(recorded("x.player", {scan}), "x.player");
  ASSERT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.scans[0].range_m[0], 8.182);
}

TEST(PlayerWriterTest, AnythingThatACarmenLogHoldsIsKeptToTheMillimetre) {
  const std::filesystem::path path = SCANBED_SOURCE_DIR "/../shared/data/legs_pos1.log";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no recording at " << path;
  Reading before;
  read_to_end(*open_recording(path, {}, {}), before);
  const Reading after = read_all(recorded("x.player", before.scans), "x.player");
  ASSERT_EQ(after.scans.size(), 197U);
  for (std::size_t i = 0; i < after.scans.size(); ++i) {
    for (int beam = 0; beam < 361; ++beam) {
      const double range_m = before.scans[i].range_m[static_cast<std::size_t>(beam)];
      ASSERT_EQ(after.scans[i].has_echo(beam), std::isfinite(range_m));
      if (std::isfinite(range_m)) {
        ASSERT_NEAR(after.scans[i].range_m[static_cast<std::size_t>(beam)], range_m, 0.00051);
      }
    }
    EXPECT_NEAR(after.scans[i].time_s, before.scans[i].time_s, 0.00051);
  }
}

}  // namespace
}  // namespace scanbed::hw
