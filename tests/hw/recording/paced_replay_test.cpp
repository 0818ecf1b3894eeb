// SPDX-License-Identifier: MIT
#include "hw/recording/paced_replay.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"
#include "tests/support/least_time.hpp"

namespace scanbed::hw {
namespace {

/// Ten scans, a quarter of a second apart.
std::unique_ptr<ScanReader> ten_scans() {
  return open_recording(from_memory(recorded("x.jsonl", made_scans(10))), "x.jsonl", {}, {});
}

std::vector<LaserScan> given(const ReplayOptions& options) {
  PacedReplay replay(ten_scans(), options);
  Reading reading;
  read_to_end(replay, reading);
  return reading.scans;
}

double seconds_to_give(const ReplayOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  given(options);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(PacedReplayTest, GivesARangeAndNumbersItFromZero) {
  const std::vector<LaserScan> scans = given({.from_s = 0.5, .to_s = 1.0});
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_EQ(scans[0].index, 0);
  EXPECT_EQ(scans[0].time_s, 0.5);
  EXPECT_EQ(scans[2].index, 2);
  EXPECT_EQ(scans[2].time_s, 1.0);
  EXPECT_EQ(given({}).size(), 10U);
}

TEST(PacedReplayTest, CountsTheScansThatItGave) {
  PacedReplay replay(ten_scans(), {.from_s = 0.5, .to_s = 1.0});
  Reading reading;
  read_to_end(replay, reading);
  EXPECT_EQ(replay.counts().num_scans, 3);
}

TEST(PacedReplayTest, KeepsTheRhythmOfTheRecording) {
  // 2.25 s between first and last scan.
  const double seconds = seconds_to_give({.speed = 10.0});
  EXPECT_GE(seconds, 0.22);
  EXPECT_LT(seconds, 20.0);
  EXPECT_LT(tests::least_seconds(0.22, [] { given({}); }), 0.22);
}

TEST(PacedReplayTest, AnAbsurdGapDoesNotHang) {
  std::vector<LaserScan> scans = made_scans(3);
  scans[1].time_s = 1e9;
  scans[2].time_s = 5.0;  // and back again
  auto reader = open_recording(from_memory(recorded("x.jsonl", scans)), "x.jsonl", {}, {});
  PacedReplay replay(std::move(reader), {.speed = 1000.0});
  Reading reading;
  const auto start = std::chrono::steady_clock::now();
  read_to_end(replay, reading);
  EXPECT_EQ(reading.scans.size(), 3U);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(PacedReplayTest, LeavesNothingOutWhereTheFirstScanIsNotTheEarliest) {
  std::vector<LaserScan> scans = made_scans(3);
  std::swap(scans[0], scans[1]);
  auto reader = open_recording(from_memory(recorded("x.jsonl", scans)), "x.jsonl", {}, {});
  PacedReplay replay(std::move(reader), {.speed = 1000.0});
  Reading reading;
  read_to_end(replay, reading);
  EXPECT_EQ(reading.scans.size(), 3U);
}

TEST(PacedReplayTest, TheEndLeavesTheScanAloneAndStays) {
  PacedReplay replay(ten_scans(), {.to_s = 0.0});
  LaserScan scan;
  EXPECT_TRUE(replay.next(scan, {}));
  scan.index = 42;
  EXPECT_FALSE(replay.next(scan, {}));
  EXPECT_FALSE(replay.next(scan, {}));
  EXPECT_EQ(scan.index, 42);
}

TEST(PacedReplayTest, RefusesBadOptionsAndEmptyRanges) {
  for (const ReplayOptions& bad :
       {ReplayOptions{.speed = 0.0}, ReplayOptions{.speed = -1.0}, ReplayOptions{.speed = HUGE_VAL},
        ReplayOptions{.from_s = -1.0}, ReplayOptions{.from_s = 2.0, .to_s = 1.0},
        ReplayOptions{.from_s = 100.0}}) {
    EXPECT_THROW(PacedReplay(ten_scans(), bad), InputError);
  }
  EXPECT_NO_THROW(ReplayOptions().validate());
}

}  // namespace
}  // namespace scanbed::hw
