// SPDX-License-Identifier: MIT
#include "hw/recording/json_lines.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

const std::string kHeader = R"({"format":"scanbed.recording","version":1,"metadata":{}})"
                            "\n";
const std::string kEnd = "{\"end\":1}\n";

std::string line(const std::string& ranges, const std::string& more = "") {
  return R"({"scan":0,"t_s":1.5,"source":"a","geometry":{"first_rad":-1,"step_rad":0.5,"min_range_m":0,)"
         R"("rotations":1,"rotation_s":0,"step_s":0},"ranges":[)" +
         ranges + "]" + more + "}\n";
}

TEST(JsonLinesTest, ReadsWhatItsHeaderDescribes) {
  const Reading reading =
      read_all(kHeader + line(R"(1.25,"inf","-inf","nan")", R"(,"odometry":[1,2,0.5])") + kEnd, "x.jsonl");
  EXPECT_EQ(reading.error, "");
  ASSERT_EQ(reading.scans.size(), 1U);
  const LaserScan& scan = reading.scans[0];
  EXPECT_EQ(scan.range_m[0], 1.25);
  EXPECT_EQ(scan.range_m[1], kNoEcho);
  EXPECT_EQ(scan.range_m[2], kTooClose);
  EXPECT_TRUE(std::isnan(scan.range_m[3]));
  EXPECT_EQ(scan.time_s, 1.5);
  EXPECT_EQ(scan.source, "a");
  EXPECT_EQ(scan.geometry.max_range_m, HUGE_VAL);
  EXPECT_EQ(scan.X_OR->theta_rad, 0.5);
}

TEST(JsonLinesTest, FeaturesTruthAndTimingComeBack) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / "x.jsonl", {});
  LaserScan scan = made_scan(1);
  scan.geometry.timing = {.num_rotations = 2, .rotation_s = 1.0 / 75.0, .step_s = 1e-5};
  const Features features = made_features();
  const Truth truth = made_truth(scan.num_beams());
  writer->write({.scan = scan, .features = &features, .truth = &truth});
  writer->write({.scan = scan});
  writer->finish();
  const Reading reading = read_all(bytes_of(folder / "x.jsonl"), "x.jsonl");
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[0].geometry.timing.num_rotations, 2);
  EXPECT_EQ(reading.scans[0].geometry.timing.rotation_s, 1.0 / 75.0);
  ASSERT_TRUE(reading.features[0].has_value());
  EXPECT_EQ(reading.features[0]->lines.size(), 2U);
  EXPECT_EQ(reading.features[0]->lines[0].slope, 1.0 / 3.0);
  EXPECT_FALSE(reading.features[0]->lines[1].slope.has_value());
  ASSERT_TRUE(reading.truths[0].has_value());
  EXPECT_EQ(reading.truths[0]->beams[3].range_m, 2.0 / 3.0);
  EXPECT_EQ(reading.truths[0]->beams[0].range_m, kNoEcho);
  EXPECT_EQ(reading.truths[0]->objects[0].id, "col_L");
  EXPECT_FALSE(reading.features[1].has_value());
  EXPECT_FALSE(reading.truths[1].has_value());
}

// More than a mebibyte in one line.
TEST(JsonLinesTest, TheTruthOfManyBeamsComesBack) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / "x.jsonl", {});
  LaserScan scan = made_scan(1);
  scan.geometry.num_beams = 18'000;
  scan.geometry.step_rad = 3e-4;
  scan.range_m.assign(18'000, 1.0 / 3.0);
  const Truth truth = made_truth(scan.num_beams());
  writer->write({.scan = scan, .truth = &truth});
  writer->finish();
  const std::string bytes = bytes_of(folder / "x.jsonl");
  EXPECT_GT(bytes.size(), std::size_t{1} << 20);
  const Reading reading = read_all(bytes, "x.jsonl");
  ASSERT_EQ(reading.scans.size(), 1U) << reading.error;
  EXPECT_EQ(reading.truths[0]->beams.size(), 18'000U);
}

TEST(JsonLinesTest, TheLaserWithoutANameIsCalledScan) {
  std::string unnamed = line("2");
  unnamed.replace(unnamed.find(R"("source":"a")"), 12, R"("source":"")");
  const std::string both = kHeader + line("1") + unnamed + kEnd;
  const Reading alone = read_all(both, "x.jsonl", {.only = "scan"});
  ASSERT_EQ(alone.scans.size(), 1U) << alone.error;
  EXPECT_EQ(alone.scans[0].range_m[0], 2.0);
  EXPECT_NE(read_all(both, "x.jsonl", {.only = "c"}).error.find("it has scans of a, scan"),
            std::string::npos);
}

TEST(JsonLinesTest, ReportsADamagedLineWithItsNumberAndReadsOn) {
  const Reading reading = read_all(kHeader + line("1") + line("-1") + line(R"("far")") + "{\"ranges\":\n" +
                                       "{\"note\":1}\n\n" + line("2") + kEnd,
                                   "x.jsonl");
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.reports, (std::vector<std::string>{
                                 "x.jsonl:3: line skipped: a range is negative",
                                 "x.jsonl:4: line skipped: a range is a text other than inf, -inf and nan",
                                 "x.jsonl:5: line skipped: not JSON at byte 10: expected a value"}));
  EXPECT_EQ(reading.counts.num_other_lines, 1);
}

TEST(JsonLinesTest, ReadsItsFirstLineInAnyOrderAndSpacing) {
  for (const char* header :
       {R"({"version": 1, "metadata": {"a": "b"}, "format": "scanbed.recording"})",
        R"(  {	"format"	:	"scanbed.recording","version":1,"metadata":{"a":"b"}} )"}) {
    const Reading reading = read_all(std::string(header) + "\r\n" + line("1") + kEnd, "x.log");
    EXPECT_EQ(reading.error, "") << header;
    EXPECT_EQ(reading.scans.size(), 1U) << header;
    EXPECT_EQ(reading.metadata.at("a"), "b") << header;
  }
}

// Two recordings, one behind the other, are one and what is too much.
TEST(JsonLinesTest, ReportsOnceWhatStandsBehindItsEnd) {
  const std::string one = kHeader + line("1") + kEnd;
  EXPECT_TRUE(read_all(one + "\n", "x.jsonl").reports.empty());
  const Reading reading = read_all(one + "\n" + one, "x.jsonl");
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.counts.num_damaged_lines, 1);
  EXPECT_EQ(reading.reports,
            std::vector<std::string>{"x.jsonl:5: line skipped: stands behind the end line, as "
                                     "all that follows does"});
}

TEST(JsonLinesTest, SaysWhereCompressedDataIsDamagedUpToItsLastByte) {
  const std::string whole = recorded("x.jsonl.gz", made_scans(40));
  EXPECT_EQ(read_all(whole, "x.jsonl.gz").error, "");
  std::string wrong_crc = whole;
  wrong_crc[wrong_crc.size() - 8] ^= 1;
  EXPECT_EQ(read_all(wrong_crc, "x.jsonl.gz").error, "x.jsonl.gz: compressed data is damaged after 40 scans");
  EXPECT_EQ(read_all(whole.substr(0, whole.size() - 1), "x.jsonl.gz").error,
            "x.jsonl.gz: compressed data is cut off after 40 scans");
  std::string flipped = whole;
  for (std::size_t i = 0; i < 8; ++i) flipped[whole.size() / 2 + i] ^= 0x55;
  const std::string error = read_all(flipped, "x.jsonl.gz").error;
  EXPECT_NE(error.find("compressed data is damaged after "), std::string::npos) << error;
}

TEST(JsonLinesTest, SaysThatItIsNotFinished) {
  const Reading reading = read_all(kHeader + line("1") + line("2"), "x.jsonl");
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.error,
            "x.jsonl: is not finished: it ends after 2 scans without an end line (cut off, or its "
            "recorder was killed)");
}

TEST(JsonLinesTest, RefusesOtherFilesAndLaterVersions) {
  EXPECT_EQ(read_all("{}\n", "x.jsonl").error, "x.jsonl:1: is not the first line of a recording of scanbed");
  EXPECT_EQ(read_all(R"(["format"])", "x.jsonl").error,
            "x.jsonl:1: is not the first line of a recording of scanbed");
  EXPECT_EQ(read_all("scans\n", "x.jsonl").error, "x.jsonl:1: not JSON at byte 0: expected a value");
  EXPECT_EQ(read_all(R"({"format":"scanbed.recording","version":2,"metadata":{}})"
                     "\n",
                     "x.jsonl")
                .error,
            "x.jsonl:1: version is 2, known is 1");
}

TEST(JsonLinesTest, ATimeBeyondAllClocksIsDamage) {
  std::string late = line("1");
  late.replace(late.find("1.5"), 3, "1e308");
  const Reading reading = read_all(kHeader + late + line("1") + kEnd, "x.jsonl");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.reports,
            std::vector<std::string>{"x.jsonl:2: line skipped: 't_s' is more than 1e12 s away from 0"});
}

TEST(JsonLinesTest, RefusesAGeometryThatCannotBe) {
  const std::string turn =
      R"({"scan":0,"t_s":0,"source":"","geometry":{"first_rad":0,"step_rad":4,"min_range_m":0,)"
      R"("rotations":1,"rotation_s":0,"step_s":0},"ranges":[1,1,1]})"
      "\n";
  const Reading reading = read_all(kHeader + turn + line("1") + kEnd, "x.jsonl");
  EXPECT_EQ(reading.scans.size(), 1U);
  ASSERT_EQ(reading.reports.size(), 1U);
  EXPECT_NE(reading.reports[0].find("spread over more than a turn"), std::string::npos);
}

TEST(JsonLinesTest, AFeatureOutsideOfTheScanIsDamage) {
  const std::string leg = R"(,"features":[{"type":"leg","first":0,"last":1,"middle":[1,1],"score":1}])";
  const Reading reading = read_all(kHeader + line("1", leg) + line("1,1", leg) + kEnd, "x.jsonl");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.reports.size(), 1U);
}

}  // namespace
}  // namespace scanbed::hw
