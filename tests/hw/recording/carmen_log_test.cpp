// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_log.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "tests/support/gzip.hpp"

namespace scanbed::hw {
namespace {

using tests::gzip;

/// All that reading a log to its end showed.
struct CarmenReading {
  std::vector<LaserScan> scans;
  std::vector<std::string> reports;
  CarmenLogCounts counts;
  std::string error;  // of the InputError that ended it, if one did
};

CarmenReading read_carmen(std::string bytes, const CarmenLogOptions& options = {}) {
  CarmenReading reading;
  const auto report = [&](const std::string& message) { reading.reports.push_back(message); };
  try {
    CarmenLog log(from_memory(std::move(bytes)), "x.log", options, report);
    LaserScan scan;
    try {
      while (log.next(scan, {})) reading.scans.push_back(scan);
    } catch (const InputError& error) {
      reading.error = error.what();
    }
    reading.counts = log.counts();
  } catch (const InputError& error) {
    reading.error = error.what();
  }
  return reading;
}

/// A scan of three readings, the first of which tells it from the others.
std::string line(int first_reading, const std::string& time = "1") {
  return "FLASER 3 " + std::to_string(first_reading) + " 2 3 0 0 0 0 0 0 " + time + " host 0\n";
}

TEST(CarmenLogTest, GivesScansInOrderAndCountsTheRest) {
  const CarmenReading reading =
      read_carmen("# a log\nPARAM a b nohost 0\n\n" + line(1, "10") + "ODOM 0 0 0\n" + line(2, "10.5"));
  EXPECT_EQ(reading.error, "");
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[0].index, 0);
  EXPECT_EQ(reading.scans[0].time_s, 10.0);
  EXPECT_EQ(reading.scans[0].range_m, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(reading.scans[1].index, 1);
  EXPECT_EQ(reading.scans[1].time_s, 10.5);
  EXPECT_EQ(reading.scans[1].range_m, (std::vector<double>{2, 2, 3}));
  EXPECT_EQ(reading.counts.num_scans, 2);
  EXPECT_EQ(reading.counts.num_other_lines, 3);
  EXPECT_EQ(reading.counts.num_damaged_lines, 0);
}

TEST(CarmenLogTest, ReportsADamagedLineWithItsNumberAndReadsOn) {
  const std::string zeros(20, '\0');
  const std::string endless = "FLASER 600000 " + std::string(17 << 20, '1');
  const CarmenReading reading = read_carmen(line(1) + "FLASER 3 1 x 3 0 0 0 0 0 0 1 host 0\n" + line(2) +
                                            zeros + "\n" + endless + "\n" + line(3));
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 3U);
  EXPECT_EQ(reading.reports,
            (std::vector<std::string>{"x.log:2: line skipped: FLASER: a reading is 'x', not a number",
                                      "x.log:4: line skipped: holds zero bytes",
                                      "x.log:5: line skipped: longer than 16 MiB"}));
  EXPECT_EQ(reading.counts.num_damaged_lines, 3);
}

TEST(CarmenLogTest, ADamagedLineLeavesNothingBehind) {
  // The damaged line has another geometry, and its odometry and time are good.
  const CarmenReading reading =
      read_carmen(line(1) + "FLASER 2 5 x 1 1 1 1 1 1 9 host 0\n" + "FLASER 3 4 2 3 0 0 0 nan 0 0\n");
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[1].geometry.num_beams, 3);
  EXPECT_EQ(reading.scans[1].range_m, (std::vector<double>{4, 2, 3}));
  EXPECT_FALSE(reading.scans[1].X_OR.has_value());
  EXPECT_EQ(reading.scans[1].time_s, 1.0);
}

TEST(CarmenLogTest, AScanWithoutTimeHasTheTimeBeforeIt) {
  const std::string bare = "FLASER 1 1 0 0 0 0 0 0\n";
  const CarmenReading reading = read_carmen(bare + line(1, "7") + bare);
  ASSERT_EQ(reading.scans.size(), 3U);
  EXPECT_EQ(reading.scans[0].time_s, 0.0);
  EXPECT_EQ(reading.scans[1].time_s, 7.0);
  EXPECT_EQ(reading.scans[2].time_s, 7.0);
}

TEST(CarmenLogTest, LineEndsMayBeOfDosOrMissing) {
  std::string text = line(1) + line(2);
  text.insert(text.find('\n'), "\r");
  text.pop_back();
  const CarmenReading reading = read_carmen(text);
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.counts.num_damaged_lines, 0);
}

TEST(CarmenLogTest, ReadsOneMessageAlone) {
  std::string rear = line(2);
  rear[0] = 'R';
  const CarmenReading both = read_carmen(line(1) + rear);
  ASSERT_EQ(both.scans.size(), 2U);
  EXPECT_EQ(both.scans[1].source, "RLASER");
  const CarmenReading alone = read_carmen(line(1) + rear, {.only = "RLASER"});
  ASSERT_EQ(alone.scans.size(), 1U);
  EXPECT_EQ(alone.scans[0].range_m[0], 2.0);
  EXPECT_EQ(alone.counts.num_other_lines, 1);
}

TEST(CarmenLogTest, KnowsTheGeometryBeforeTheFirstScanIsGiven) {
  CarmenLog log(from_memory(line(1) + "FLASER 2 1 x 0 0 0 0 0 0\n"), "x.log", {}, {});
  EXPECT_EQ(log.geometry().num_beams, 3);
  LaserScan scan;
  EXPECT_TRUE(log.next(scan, {}));
  EXPECT_FALSE(log.next(scan, {}));
  EXPECT_EQ(log.geometry().num_beams, 3) << "the damaged line's geometry is not the scan's";
}

TEST(CarmenLogTest, TheEndLeavesTheScanAloneAndStays) {
  CarmenLog log(from_memory(line(1)), "x.log", {}, {});
  LaserScan scan;
  EXPECT_TRUE(log.next(scan, {}));
  scan.index = 42;
  EXPECT_FALSE(log.next(scan, {}));
  EXPECT_FALSE(log.next(scan, {}));
  EXPECT_EQ(scan.index, 42);
  EXPECT_EQ(scan.range_m, (std::vector<double>{1, 2, 3}));
}

TEST(CarmenLogTest, ReadsGzipAndJoinedGzip) {
  EXPECT_EQ(read_carmen(gzip(line(1) + line(2))).scans.size(), 2U);
  const CarmenReading joined = read_carmen(gzip(line(1)) + gzip(line(2) + line(3)));
  EXPECT_EQ(joined.scans.size(), 3U);
  EXPECT_EQ(joined.error, "");
}

TEST(CarmenLogTest, OfAGzipCutAtAnyByteGivesWhatIsCompleteAndSaysSo) {
  std::string text = "# a log\n";
  for (int i = 0; i < 20; ++i) text += line(i + 1, std::to_string(i * i));
  const CarmenReading whole = read_carmen(text);
  const std::string packed = gzip(text);
  for (std::size_t size = 2; size < packed.size(); ++size) {
    const CarmenReading reading = read_carmen(packed.substr(0, size));
    EXPECT_EQ(reading.error,
              "x.log: compressed data is cut off after " + std::to_string(reading.scans.size()) + " scans");
    EXPECT_EQ(reading.counts.num_damaged_lines, 0) << size;
    ASSERT_LE(reading.scans.size(), whole.scans.size());
    for (std::size_t i = 0; i < reading.scans.size(); ++i) {
      EXPECT_EQ(reading.scans[i].range_m, whole.scans[i].range_m) << size;
      EXPECT_EQ(reading.scans[i].time_s, whole.scans[i].time_s) << size;
    }
  }
  EXPECT_EQ(read_carmen(packed.substr(0, packed.size() - 1)).scans.size(), 20U);
}

TEST(CarmenLogTest, SaysThatAGzipIsDamaged) {
  std::string packed = gzip(line(1));
  packed[packed.size() - 8] ^= 1;  // its checksum
  EXPECT_EQ(read_carmen(packed).error, "x.log: compressed data is damaged after 1 scans");
}

TEST(CarmenLogTest, RefusesALogWithoutScans) {
  EXPECT_EQ(read_carmen("").error, "x.log: holds no scan of a CARMEN log (0 damaged lines, 0 others)");
  EXPECT_EQ(read_carmen("# nothing\nFLASER x\n").error,
            "x.log: holds no scan of a CARMEN log (1 damaged lines, 1 others)");
  EXPECT_EQ(read_carmen(gzip("")).error, "x.log: holds no scan of a CARMEN log (0 damaged lines, 0 others)");
  EXPECT_EQ(read_carmen(line(1), {.only = "RAWLASER1"}).error,
            "x.log: holds no scan of a CARMEN log with only=RAWLASER1; it has scans of FLASER (0 damaged "
            "lines, 1 others)");
}

TEST(CarmenLogTest, RefusesBadOptionsAndMissingFiles) {
  EXPECT_THROW(CarmenLog(from_memory(line(1)), "x.log", {.only = "XLASER"}, {}), InputError);
  EXPECT_THROW(CarmenLog("/nowhere/x.log", {}, {}), InputError);
}

/// The recordings beside the project; they are not part of it.
std::filesystem::path recording(const std::string& name) {
  return std::filesystem::path(SCANBED_SOURCE_DIR "/../shared/data") / name;
}

struct Recording {
  const char* name;
  int num_scans;

  // Otherwise GoogleTest prints its bytes, and the test's name changes from build to build.
  friend std::ostream& operator<<(std::ostream& out, const Recording& recording) {
    return out << recording.name;
  }
};

class RecordedLogTest : public testing::TestWithParam<Recording> {};

TEST_P(RecordedLogTest, GivesAllItsScans) {
  const std::filesystem::path path = recording(GetParam().name);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no recording at " << path;
  CarmenLog log(path, {}, {});
  int num_echoes = 0;
  double time_s = -1.0;
  for (LaserScan scan; log.next(scan, {});) {
    ASSERT_EQ(scan.num_beams(), 361);
    EXPECT_EQ(scan.geometry.first_rad, -kPi / 2);
    EXPECT_EQ(scan.geometry.step_rad, kPi / 360);
    EXPECT_GT(scan.time_s, time_s);
    time_s = scan.time_s;
    for (int i = 0; i < scan.num_beams(); ++i) num_echoes += static_cast<int>(scan.has_echo(i));
    for (const double range_m : scan.range_m) EXPECT_TRUE(range_m == kNoEcho || range_m < 81.83);
  }
  EXPECT_EQ(log.counts().num_scans, GetParam().num_scans);
  EXPECT_EQ(log.counts().num_damaged_lines, 0);
  EXPECT_EQ(log.counts().num_other_lines, 2);
  EXPECT_GT(num_echoes, GetParam().num_scans * 361 / 4);
}

// Numbers of scans as the recordings' own README states them (nobody.log included).
INSTANTIATE_TEST_SUITE_P(Recordings, RecordedLogTest,
                         testing::Values(Recording{"columns_hall.log", 37}, Recording{"legs_pos1.log", 197},
                                         Recording{"legs_pos2.log", 83}, Recording{"nobody.log", 109}),
                         [](const auto& instance) {
                           const std::string name = instance.param.name;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace scanbed::hw
