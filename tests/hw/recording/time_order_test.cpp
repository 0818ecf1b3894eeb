// SPDX-License-Identifier: MIT
#include "hw/recording/time_order.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <tuple>

#include "hw/recording/bag_reader.hpp"
#include "hw/recording/bag_record.hpp"
#include "hw/recording/mcap_record.hpp"
#include "hw/recording/paced_replay.hpp"
#include "hw/serial/steady_clock.hpp"
#include "tests/hw/recording/late_parts.hpp"
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

/// Where each chunk of a bag or MCAP file ends.
std::vector<std::size_t> chunk_ends(const std::string& name, const std::string& bytes) {
  const bool is_bag = name.ends_with(".bag");
  ByteCursor cursor(bytes);
  cursor.take(is_bag ? kBagMagic.size() : kMcapMagic.size());
  std::vector<std::size_t> ends;
  while (cursor.num_left() > kMcapMagic.size()) {
    const auto is_chunk = [&] {
      if (!is_bag) return static_cast<McapOp>(cursor.number<std::uint8_t>()) == McapOp::kChunk;
      return bag_op(cursor.piece()) == BagOp::kChunk;
    }();
    cursor.take(is_bag ? cursor.number<std::uint32_t>() : cursor.number<std::uint64_t>());
    if (is_chunk) ends.push_back(bytes.size() - cursor.num_left());
  }
  return ends;
}

/// A recording whose chunks arrive one after another, each with the first bytes of what follows it.
std::vector<std::string> parts_of(const std::string& name, const std::string& bytes, std::size_t num_beyond) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (const std::size_t end : chunk_ends(name, bytes)) {
    parts.push_back(bytes.substr(begin, end + num_beyond - begin));
    begin = end + num_beyond;
  }
  parts.push_back(bytes.substr(begin));
  return parts;
}

std::vector<LaserScan> scans_at(const std::vector<double>& times_s) {
  std::vector<LaserScan> scans = made_scans(static_cast<int>(times_s.size()));
  for (std::size_t i = 0; i < scans.size(); ++i) scans[i].time_s = times_s[i];
  return scans;
}

// Of a recorder that runs: what it has written whole is given before it has written more.
TEST(TimeOrderTest, AScanOfALiveRecordingDoesNotWaitForThoseBehind) {
  const std::vector<LaserScan> scans = scans_at({0.0, 10.0, 20.0, 30.0});
  for (const std::string name : {"x.bag", "x.mcap"}) {
    for (const std::size_t num_beyond : {0U, 1U, 5U, 12U, 100U}) {
      const std::vector<std::string> parts = parts_of(name, recorded(name, scans), num_beyond);
      ASSERT_EQ(parts.size(), scans.size() + 1) << name;
      std::size_t num_arrived = 0;
      const auto reader = open_recording(std::make_unique<LateParts>(parts, num_arrived), name, {}, {});
      LaserScan scan;
      for (std::size_t i = 0; i < scans.size(); ++i) {
        ASSERT_TRUE(reader->next(scan, {})) << name;
        EXPECT_EQ(scan.time_s, scans[i].time_s) << name << num_beyond;
        EXPECT_EQ(num_arrived, i + 1) << name << num_beyond;
      }
      EXPECT_FALSE(reader->next(scan, {}));
      EXPECT_EQ(reader->counts().num_damaged_lines, 0) << name;
    }
  }
}

// The format shows in the first bytes, and a small scan is whole long before the reader has seen many.
TEST(TimeOrderTest, AShortBeginningOfALiveRecordingIsEnough) {
  std::vector<LaserScan> scans = scans_at({0.0, 10.0});
  for (LaserScan& scan : scans) {
    scan.range_m.resize(3);
    scan.geometry.num_beams = 3;
  }
  const std::vector<std::string> parts = parts_of("x.mcap", recorded("x.mcap", scans), 0);
  ASSERT_LT(parts[0].size(), 4096U);
  std::size_t num_arrived = 0;
  open_recording(std::make_unique<LateParts>(parts, num_arrived), "no_ending", {}, {});
  EXPECT_EQ(num_arrived, 1U);
}

// What arrives together is put in order; what comes too late for that is given and told.
TEST(TimeOrderTest, ALiveRecordingIsInOrderAsFarAsItHasArrived) {
  const std::vector<LaserScan> scans = scans_at({50.0, 100.0, 0.0, 99.0});
  for (const std::string name : {"x.bag", "x.mcap"}) {
    const std::string bytes = recorded(name, scans);
    for (const auto& [parts, times_s, num_reports] :
         {std::tuple{std::vector{bytes}, std::vector{0.0, 50.0, 99.0, 100.0}, 0U},
          {parts_of(name, bytes, 0), {50.0, 0.0, 99.0, 100.0}, 1U}}) {
      std::size_t num_arrived = 0;
      std::vector<std::string> reports;
      const auto reader = open_recording(std::make_unique<LateParts>(parts, num_arrived), name, {},
                                         [&](const std::string& report) { reports.push_back(report); });
      Reading reading;
      read_to_end(*reader, reading);
      std::vector<double> given_s;
      for (const LaserScan& scan : reading.scans) given_s.push_back(scan.time_s);
      EXPECT_EQ(given_s, times_s) << name;
      ASSERT_EQ(reports.size(), num_reports) << name;
      for (const std::string& report : reports) {
        EXPECT_NE(report.find(", or 0.1 s, behind"), std::string::npos) << report;
      }
    }
  }
}

/// Scans that arrive at times of this machine's clock.
class ArrivingSource final : public ScanSource {
 public:
  explicit ArrivingSource(std::vector<double> after_s) : after_s_(std::move(after_s)) {}

  bool read(RecordedScan& out) override { return read_until(out, kNoDeadline_s) == Arrival::kScan; }

  Arrival read_until(RecordedScan& out, double deadline_s) override {
    if (num_read_ == after_s_.size()) return Arrival::kEnd;
    const double arrival_s = start_s_ + after_s_[num_read_];
    const double end_s = std::min(arrival_s, deadline_s);
    while (steady_now_s() < end_s) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (steady_now_s() < arrival_s) return Arrival::kNothingYet;
    out.scan.time_s = -static_cast<double>(num_read_++);
    return Arrival::kScan;
  }

 private:
  std::vector<double> after_s_;
  std::size_t num_read_ = 0;
  double start_s_ = steady_now_s();
};

// Lasers whose scans are stamped earlier and arrive later: the first is not given at once.
TEST(TimeOrderTest, AScanIsHeldForThoseThatArriveALittleLater) {
  const double before_s = steady_now_s();
  const auto source = in_time_order(std::make_unique<ArrivingSource>(std::vector{0.0, 0.01, 60.0}), "x", {});
  RecordedScan out;
  ASSERT_TRUE(source->read(out));
  EXPECT_EQ(out.scan.time_s, -1.0);
  EXPECT_GE(steady_now_s() - before_s, 0.1);
  ASSERT_TRUE(source->read(out));
  EXPECT_EQ(out.scan.time_s, 0.0);
  EXPECT_LT(steady_now_s() - before_s, 50.0);
}

}  // namespace
}  // namespace scanbed::hw
