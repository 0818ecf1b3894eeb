// SPDX-License-Identifier: MIT
#include "hw/recording/streamed_reader.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

/// Gives so many scans, the second with truth, and then ends or fails.
class FakeSource final : public ScanSource {
 public:
  FakeSource(int num_scans, bool fails) : num_scans_(num_scans), fails_(fails) { metadata_["a"] = "b"; }

  bool read(RecordedScan& out) override {
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

TEST(StreamedReaderTest, RefusesARecordingWithoutScans) {
  EXPECT_THROW(StreamedReader(std::make_unique<FakeSource>(0, false), "x"), InputError);
  EXPECT_THROW(StreamedReader(std::make_unique<FakeSource>(0, true), "x"), InputError);
}

}  // namespace
}  // namespace scanbed::hw
