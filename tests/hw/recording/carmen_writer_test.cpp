// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

LaserScan three_beams() {
  LaserScan scan;
  scan.geometry = {.num_beams = 3, .first_rad = -0.5, .step_rad = 0.5, .max_range_m = 8.0};
  scan.range_m = {1.5, kNoEcho, 0.25};
  scan.time_s = 2.5;
  return scan;
}

/// Of a log, the lines that are no comments.
std::string messages(const std::string& log) {
  std::string out;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) out += line + "\n";
  }
  return out;
}

TEST(CarmenWriterTest, WritesTheFieldsOfTheMessage) {
  EXPECT_EQ(messages(recorded("x.log", {three_beams()})),
            "RAWLASER1 0 -0.5 1 0.5 8 0.001 0 3 1.5 81.91 0.25 0 2.5 scanbed 2.5\n");
  LaserScan moved = three_beams();
  moved.X_OR = Pose2{{1.0, 2.0}, 0.5};
  EXPECT_EQ(
      messages(recorded("x.log", {moved})),
      "ROBOTLASER1 0 -0.5 1 0.5 8 0.001 0 3 1.5 81.91 0.25 0 1 2 0.5 1 2 0.5 0 0 0 0 0 2.5 scanbed 2.5\n");
}

TEST(CarmenWriterTest, TheSourcesOwnMessageIsKeptWhereItCanHoldTheScan) {
  LaserScan scan = made_scan(1);
  scan.geometry.max_range_m = 81.83;
  scan.source = "FLASER";
  EXPECT_TRUE(messages(recorded("x.log", {scan})).starts_with("FLASER 361 "));
  scan.geometry.first_rad = 0.0;
  EXPECT_TRUE(messages(recorded("x.log", {scan})).starts_with("ROBOTLASER1 "));
  scan.X_OR.reset();
  scan.source = "RAWLASER3";
  EXPECT_TRUE(messages(recorded("x.log", {scan})).starts_with("RAWLASER3 "));
}

// The reader takes readings from the maximum range on for "no return".
TEST(CarmenWriterTest, ARangeAtTheLimitIsStillARange) {
  LaserScan scan = three_beams();
  scan.range_m[0] = scan.geometry.max_range_m;
  const Reading reading = read_all(recorded("x.log", {scan}), "x.log");
  ASSERT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.scans[0].range_m[0], 8.0);
}

TEST(CarmenWriterTest, FarRangesComeBack) {
  for (const double max_range_m : {81.9, 200.0, HUGE_VAL}) {
    LaserScan scan = three_beams();
    scan.geometry.max_range_m = max_range_m;
    scan.range_m = {81.85, kNoEcho, max_range_m > 100.0 ? 150.0 : 3.0};
    const Reading reading = read_all(recorded("x.log", {scan}), "x.log");
    ASSERT_EQ(reading.scans.size(), 1U);
    EXPECT_EQ(reading.scans[0].range_m, scan.range_m) << max_range_m;
  }
}

TEST(CarmenWriterTest, LasersAreToldApart) {
  std::vector<LaserScan> scans(6, three_beams());
  for (std::size_t i = 0; i < 3; ++i) scans[i].source = std::array{"front", "rear", "front"}[i];
  scans[3].source = "RAWLASER4";
  for (std::size_t i = 4; i < 6; ++i) {
    scans[i].source = std::array{"front", "ROBOTLASER1"}[i - 4];
    scans[i].X_OR = Pose2{};
  }
  std::vector<std::string> found;
  for (const LaserScan& scan : read_all(recorded("x.log", scans), "x.log").scans)
    found.push_back(scan.source);
  EXPECT_EQ(found, (std::vector<std::string>{"RAWLASER1", "RAWLASER2", "RAWLASER1", "RAWLASER4",
                                             "ROBOTLASER1", "ROBOTLASER2"}));
  for (std::size_t i = 0; i < 5; ++i) {
    scans[i].source = "laser" + std::to_string(i);
    scans[i].X_OR.reset();
  }
  EXPECT_THROW(recorded("x.log", scans), InputError);
}

TEST(CarmenWriterTest, RecordedLogsComeBackAsTheyWere) {
  const std::filesystem::path path = SCANBED_SOURCE_DIR "/../shared/data/columns_hall.log";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no recording at " << path;
  Reading before;
  read_to_end(*open_recording(path, {}, {}), before);
  const Reading after = read_all(recorded("x.log", before.scans), "x.log");
  ASSERT_EQ(after.scans.size(), 37U);
  for (std::size_t i = 0; i < after.scans.size(); ++i) {
    EXPECT_TRUE(same_ranges(after.scans[i], before.scans[i]));
    EXPECT_EQ(after.scans[i].time_s, before.scans[i].time_s);
    EXPECT_EQ(after.scans[i].source, before.scans[i].source);
  }
}

}  // namespace
}  // namespace scanbed::hw
