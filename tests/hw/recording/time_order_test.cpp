// SPDX-License-Identifier: MIT
#include "hw/recording/time_order.hpp"

#include <gtest/gtest.h>

#include "hw/recording/paced_replay.hpp"
#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

/// Gives scans of these times, numbered by their index, and then ends or fails.
class TimedSource final : public ScanSource {
 public:
  TimedSource(std::vector<double> times_s, bool fails) : times_s_(std::move(times_s)), fails_(fails) {}

  bool read(RecordedScan& out) override {
    if (num_read_ == times_s_.size() && fails_) throw InputError("x: cut off");
    if (num_read_ == times_s_.size()) return false;
    out = {};
    out.scan.time_s = times_s_[num_read_];
    out.scan.index = static_cast<std::int64_t>(num_read_++);
    counts_.num_other_lines = 7;
    metadata_["a"] = "b";
    return true;
  }

 private:
  std::vector<double> times_s_;
  bool fails_;
  std::size_t num_read_ = 0;
};

struct Ordered {
  std::vector<std::int64_t> numbers;
  std::vector<double> times_s;
  std::vector<std::string> reports;
  std::string error;
};

Ordered ordered(std::vector<double> times_s, bool fails = false) {
  Ordered result;
  const auto source = in_time_order(std::make_unique<TimedSource>(std::move(times_s), fails), "x",
                                    [&](const std::string& message) { result.reports.push_back(message); });
  try {
    for (RecordedScan out; source->read(out);) {
      result.numbers.push_back(out.scan.index);
      result.times_s.push_back(out.scan.time_s);
    }
  } catch (const InputError& error) {
    result.error = error.what();
  }
  EXPECT_EQ(source->counts().num_other_lines, 7);
  EXPECT_EQ(source->metadata().at("a"), "b");
  return result;
}

TEST(TimeOrderTest, SortsAndLeavesEqualTimesAsTheyStand) {
  const Ordered result = ordered({3.0, 1.0, 2.0, 1.0, 3.0, 1.0});
  EXPECT_EQ(result.numbers, (std::vector<std::int64_t>{1, 3, 5, 2, 0, 4}));
  EXPECT_TRUE(result.reports.empty());
  EXPECT_EQ(result.error, "");
}

TEST(TimeOrderTest, WhatTheSourceThrowsComesLast) {
  const Ordered result = ordered({2.0, 1.0}, true);
  EXPECT_EQ(result.numbers, (std::vector<std::int64_t>{1, 0}));
  EXPECT_EQ(result.error, "x: cut off");
}

TEST(TimeOrderTest, AScanFarBehindIsGivenAndReported) {
  std::vector<double> times_s;
  for (int i = 0; i < 5000; ++i) times_s.push_back(1.0 + i);
  times_s.insert(times_s.end(), {0.25, 0.5});
  const Ordered result = ordered(times_s);
  std::vector<double> given_s = result.times_s;
  EXPECT_FALSE(std::is_sorted(given_s.begin(), given_s.end()));
  std::sort(given_s.begin(), given_s.end());
  std::sort(times_s.begin(), times_s.end());
  EXPECT_EQ(given_s, times_s);
  ASSERT_EQ(result.reports.size(), 1U);
  EXPECT_NE(result.reports[0].find("x: a scan of 0.25"), std::string::npos) << result.reports[0];
}

// Of a bag whose recording is cut in pieces that are put together in another order.
TEST(TimeOrderTest, APartOfARecordingWithoutOrderIsWhole) {
  const std::vector<LaserScan> scans = made_scans(6);
  for (const std::string name : {"x.bag", "x.mcap"}) {
    const std::string bytes = recorded(name, {scans[4], scans[5], scans[1], scans[0], scans[3], scans[2]});
    PacedReplay replay(open_recording(from_memory(bytes), name, {}, {}), {.speed = 1e6, .to_s = 1.0});
    Reading reading;
    read_to_end(replay, reading);
    ASSERT_EQ(reading.scans.size(), 5U) << name;
    for (int i = 0; i < 5; ++i) EXPECT_EQ(reading.scans[static_cast<std::size_t>(i)].time_s, 0.25 * i);
  }
}

}  // namespace
}  // namespace scanbed::hw
