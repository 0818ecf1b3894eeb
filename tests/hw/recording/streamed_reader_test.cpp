// SPDX-License-Identifier: MIT
#include "hw/recording/streamed_reader.hpp"

#include <gtest/gtest.h>

#include "hw/serial/stop_signal.hpp"
#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

/// Gives so many scans, the second with truth, and then ends or fails.
class FakeSource final : public ScanSource {
 public:
  FakeSource(int num_scans, bool fails) : num_scans_(num_scans), fails_(fails) { metadata_["a"] = "b"; }

  bool is_interrupted = false;  // while it waits for a scan

  bool read(RecordedScan& out) override {
    if (is_interrupted) throw Stopped{};
    out = {};  // a source may leave anything behind where there is no scan
    if (num_read_ == num_scans_ && fails_) {
      ++counts_.num_damaged_lines;
      throw InputError("x: cut off");
    }
    if (num_read_ == num_scans_) return false;
    out.scan = made_scan(num_read_);
    out.scan.index = 99;
    if (num_read_ == 1) out.truth = made_truth(361);
    ++num_read_;
    return true;
  }

 private:
  int num_scans_;
  bool fails_;
  int num_read_ = 0;
};

TEST(StreamedReaderTest, NumbersScansAndGivesWhatBelongsToThem) {
  StreamedReader reader(std::make_unique<FakeSource>(2, false), "x");
  EXPECT_EQ(reader.geometry().num_beams, 361);
  EXPECT_EQ(reader.truth(), nullptr);
  LaserScan scan;
  ASSERT_TRUE(reader.next(scan, {}));
  EXPECT_EQ(scan.index, 0);
  EXPECT_EQ(reader.truth(), nullptr);
  ASSERT_TRUE(reader.next(scan, {}));
  EXPECT_EQ(scan.index, 1);
  ASSERT_NE(reader.truth(), nullptr);
  EXPECT_EQ(reader.truth()->objects.size(), 1U);
  EXPECT_EQ(reader.features(), nullptr);
  EXPECT_EQ(reader.counts().num_scans, 2);
  EXPECT_EQ(reader.metadata().at("a"), "b");
}

TEST(StreamedReaderTest, TheEndLeavesTheScanAloneAndStays) {
  StreamedReader reader(std::make_unique<FakeSource>(1, false), "x");
  LaserScan scan;
  EXPECT_TRUE(reader.next(scan, {}));
  scan.index = 42;
  EXPECT_FALSE(reader.next(scan, {}));
  EXPECT_FALSE(reader.next(scan, {}));
  EXPECT_EQ(scan.index, 42);
  EXPECT_EQ(reader.geometry().num_beams, 361);
}

TEST(StreamedReaderTest, AFailureComesOnceAfterTheScansBeforeIt) {
  StreamedReader reader(std::make_unique<FakeSource>(1, true), "x");
  LaserScan scan;
  EXPECT_TRUE(reader.next(scan, {}));
  EXPECT_THROW(reader.next(scan, {}), InputError);
  EXPECT_FALSE(reader.next(scan, {}));
  EXPECT_EQ(reader.counts().num_scans, 1);
  EXPECT_EQ(reader.counts().num_damaged_lines, 1);
}

TEST(StreamedReaderTest, AnInterruptIsTheEndButBeforeTheFirstScan) {
  auto source = std::make_unique<FakeSource>(3, false);
  FakeSource& interrupted = *source;
  StreamedReader reader(std::move(source), "x");
  LaserScan scan;
  interrupted.is_interrupted = true;
  EXPECT_TRUE(reader.next(scan, {})) << "read ahead";
  EXPECT_FALSE(reader.next(scan, {}));
  interrupted.is_interrupted = false;
  EXPECT_FALSE(reader.next(scan, {}));
  auto from_the_start = std::make_unique<FakeSource>(3, false);
  from_the_start->is_interrupted = true;
  EXPECT_THROW(StreamedReader(std::move(from_the_start), "x"), Stopped);
}

TEST(StreamedReaderTest, ReadingsFromTheLimitOnAreNoEchoes) {
  const LaserScan plain = made_scan(0);
  const double limit_m = plain.range_m[200];
  StreamedReader reader(std::make_unique<FakeSource>(1, false), "x", {.no_return_m = limit_m});
  LaserScan scan;
  ASSERT_TRUE(reader.next(scan, {}));
  EXPECT_EQ(scan.range_m[200], kNoEcho);
  for (int i = 0; i < plain.num_beams(); ++i) {
    EXPECT_EQ(scan.has_echo(i), plain.has_echo(i) && plain.range_m[i] < limit_m) << i;
  }
}

TEST(StreamedReaderTest, RefusesARecordingWithoutScans) {
  EXPECT_THROW(StreamedReader(std::make_unique<FakeSource>(0, false), "x"), InputError);
  EXPECT_THROW(StreamedReader(std::make_unique<FakeSource>(0, true), "x"), InputError);
}

}  // namespace
}  // namespace scanbed::hw
