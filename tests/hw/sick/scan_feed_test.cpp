// SPDX-License-Identifier: MIT
#include "hw/sick/scan_feed.hpp"

#include <gtest/gtest.h>

#include "core/errors/sensor_fault.hpp"
#include "tests/support/numbered_sensor.hpp"

namespace scanbed::hw {
namespace {

/// Two scans of 91 beams over the front quarter, 1 and 2 m away.
class TwoScans final : public RangeSensor {
 public:
  TwoScans() {
    geometry_.num_beams = 91;
    geometry_.first_rad = radians(-45.0);
    geometry_.step_rad = radians(1.0);
  }
  const ScanGeometry& geometry() const override { return geometry_; }
  bool next(LaserScan& scan, Seconds /*timeout*/) override {
    if (count_ == 2) return false;
    scan.geometry = geometry_;
    scan.range_m.assign(91, ++count_);
    return true;
  }

 private:
  ScanGeometry geometry_;
  int count_ = 0;
};

class Nothing final : public RangeSensor {
 public:
  const ScanGeometry& geometry() const override { return geometry_; }
  bool next(LaserScan& /*scan*/, Seconds /*timeout*/) override { return false; }

 private:
  ScanGeometry geometry_;
};

TEST(ScanFeedTest, GivesTheWordsOfTheConfiguredBeams) {
  ScanFeed feed(tests::numbered_source(), {});
  feed.restart({{100, 25}, RangeUnit::kCentimetre}, {});
  const auto& words = feed.next();
  ASSERT_EQ(words.size(), 401U);
  for (int i = 0; i < 401; ++i) EXPECT_EQ(words[static_cast<std::size_t>(i)], tests::numbered_steps(0, i));
}

TEST(ScanFeedTest, BeamsThatTheSourceLacksHaveNoEcho) {
  ScanFeed feed([](const LmsStreamSettings&) { return std::make_unique<TwoScans>(); }, {});
  feed.restart({{180, 50}, RangeUnit::kMillimetre}, {});
  const auto& words = feed.next();
  ASSERT_EQ(words.size(), 361U);
  EXPECT_EQ(words[0], kLmsNoStopSignal);
  EXPECT_EQ(words[80], kLmsNoStopSignal);  // -50 degrees
  EXPECT_EQ(words[90], 1000);              // -45 degrees
  EXPECT_EQ(words[270], 1000);
  EXPECT_EQ(words[280], kLmsNoStopSignal);
}

TEST(ScanFeedTest, BeginsAnewWhereTheSourceEnds) {
  std::vector<std::int64_t> numbers;
  ScanFeed feed([](const LmsStreamSettings&) { return std::make_unique<TwoScans>(); },
                [&](const SentScan& sent) { numbers.push_back(sent.number); });
  feed.restart({{180, 100}, RangeUnit::kMillimetre}, {});
  std::vector<int> ranges;
  for (int i = 0; i < 5; ++i) ranges.push_back(feed.next()[90]);
  EXPECT_EQ(ranges, (std::vector<int>{1000, 2000, 1000, 2000, 1000}));
  EXPECT_EQ(numbers, (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
}

TEST(ScanFeedTest, ASourceWithoutScansIsAFault) {
  ScanFeed feed([](const LmsStreamSettings&) { return std::make_unique<Nothing>(); }, {});
  feed.restart({}, {});
  EXPECT_THROW(feed.next(), SensorFault);
}

}  // namespace
}  // namespace scanbed::hw
