// SPDX-License-Identifier: MIT
#include "hw/recording/open_recording.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/detect/feature_detector.hpp"
#include "tests/hw/recording/made_recording.hpp"
#include "tests/support/gzip.hpp"

namespace scanbed::hw {
namespace {

class EveryFormatTest : public testing::TestWithParam<std::string> {};

// One conformance test for all formats: what a detector sees must come back.
TEST_P(EveryFormatTest, BringsBackRangesAnglesTimesAndOdometry) {
  const std::vector<LaserScan> scans = made_scans(9);
  const Reading reading = read_all(recorded(GetParam(), scans), GetParam());
  EXPECT_EQ(reading.error, "");
  EXPECT_TRUE(reading.reports.empty());
  ASSERT_EQ(reading.scans.size(), scans.size());
  const bool merges_invalid = GetParam().find(".player") != std::string::npos;  // see write_player_log
  for (std::size_t i = 0; i < scans.size(); ++i) {
    LaserScan expected = scans[i];
    if (merges_invalid) expected.range_m[4] = kTooClose;
    EXPECT_TRUE(same_ranges(reading.scans[i], expected)) << i;
    EXPECT_EQ(reading.scans[i].geometry.first_rad, expected.geometry.first_rad);
    EXPECT_EQ(reading.scans[i].geometry.step_rad, expected.geometry.step_rad);
    EXPECT_EQ(reading.scans[i].geometry.num_beams, expected.geometry.num_beams);
    EXPECT_EQ(reading.scans[i].time_s, expected.time_s);
    EXPECT_EQ(reading.scans[i].index, static_cast<std::int64_t>(i));
    ASSERT_TRUE(reading.scans[i].X_OR.has_value());
    EXPECT_LT((reading.scans[i].X_OR->p_m - expected.X_OR->p_m).norm(), 1e-3);
    EXPECT_NEAR(reading.scans[i].X_OR->theta_rad, expected.X_OR->theta_rad, 1e-3);
  }
}

// Ranges come back to the bit, so features must, too.
TEST_P(EveryFormatTest, GivesTheSameFeatures) {
  const std::vector<LaserScan> scans = made_scans(3);
  const Reading reading = read_all(recorded(GetParam(), scans), GetParam());
  FeatureDetector before(paper_options());
  FeatureDetector after(paper_options());
  ASSERT_EQ(reading.scans.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Features& expected = before.detect(scans[i]);
    const Features& features = after.detect(reading.scans[i]);
    ASSERT_EQ(features.lines.size(), expected.lines.size());
    ASSERT_EQ(features.circles.size(), expected.circles.size());
    ASSERT_EQ(features.legs.size(), expected.legs.size());
    for (std::size_t k = 0; k < expected.lines.size(); ++k) {
      EXPECT_EQ(features.lines[k].left_m, expected.lines[k].left_m);
      EXPECT_EQ(features.lines[k].right_m, expected.lines[k].right_m);
    }
  }
}

TEST_P(EveryFormatTest, ContentTellsTheFormatWhateverTheName) {
  const Reading reading = read_all(recorded(GetParam(), made_scans(2)), "no_ending");
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 2U);
}

// Whatever is cut off: the scans before are right, and at most one clear error follows.
TEST_P(EveryFormatTest, CutAtAnyByteGivesScansFromTheBeginningOrOneError) {
  std::vector<LaserScan> scans = made_scans(4);
  for (LaserScan& scan : scans) {
    scan.range_m.resize(8);
    scan.geometry.num_beams = 8;
    scan.time_s *= 10.0;  // each in a chunk of its own
  }
  const std::string whole = recorded(GetParam(), scans);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Reading reading = read_all(whole.substr(0, size), GetParam());
    ASSERT_LE(reading.scans.size(), scans.size());
    for (std::size_t i = 0; i < reading.scans.size(); ++i) {
      // A text line that was cut within its last number is another number.
      if (i + 1 == reading.scans.size()) continue;
      EXPECT_EQ(reading.scans[i].range_m[0], scans[i].range_m[0]);
    }
    if (!reading.error.empty()) {
      EXPECT_TRUE(reading.error.starts_with(GetParam() + ":")) << reading.error;
      EXPECT_EQ(reading.error.find('\n'), std::string::npos);
      EXPECT_LT(reading.error.size(), 200U);
    }
    EXPECT_TRUE(size > 0 || !reading.error.empty());
  }
}

// Every reader is bounded and ends, whatever bytes it gets.
TEST_P(EveryFormatTest, AFlippedByteIsNoCrash) {
  std::vector<LaserScan> scans = made_scans(2);
  for (LaserScan& scan : scans) {
    scan.range_m.resize(8);
    scan.geometry.num_beams = 8;
  }
  const std::string whole = recorded(GetParam(), scans);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::string flipped = whole;
      flipped[i] = static_cast<char>(flipped[i] ^ flip);
      const Reading reading = read_all(flipped, GetParam());
      EXPECT_LE(reading.scans.size(), 3U);
      for (const std::string& report : reading.reports) EXPECT_LT(report.size(), 300U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormatTest,
                         testing::Values("x.jsonl", "x.jsonl.gz", "x.mcap", "x.bag", "x.log", "x.log.gz",
                                         "x.player"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(OpenRecordingTest, SourcesComeBack) {
  std::vector<LaserScan> scans = made_scans(3);
  scans[1].source = "RLASER";
  for (const char* name : {"x.jsonl", "x.mcap", "x.bag", "x.player"}) {
    const Reading reading = read_all(recorded(name, scans), name);
    ASSERT_EQ(reading.scans.size(), 3U) << name << ": " << reading.error;
    EXPECT_EQ(reading.scans[0].source, "") << name;
    EXPECT_EQ(reading.scans[1].source, "RLASER") << name;
    EXPECT_EQ(reading.scans[2].source, "") << name;
  }
}

TEST(OpenRecordingTest, OneSourceAloneCanBeRead) {
  std::vector<LaserScan> scans = made_scans(3);
  scans[1].source = "RLASER";
  for (const char* name : {"x.jsonl", "x.mcap", "x.bag", "x.player"}) {
    const Reading reading = read_all(recorded(name, scans), name, {.only = "RLASER"});
    ASSERT_EQ(reading.scans.size(), 1U) << name << ": " << reading.error;
    EXPECT_EQ(reading.scans[0].range_m[0], scans[1].range_m[0]);
  }
}

TEST(OpenRecordingTest, SaysWhichSourcesThereAreWhereNoneIsTheOneAskedFor) {
  std::vector<LaserScan> scans = made_scans(2);
  scans[0].source = "front";
  scans[1].source = "rear";
  for (const char* name : {"x.jsonl", "x.mcap", "x.bag", "x.player"}) {
    const std::string error = read_all(recorded(name, scans), name, {.only = "top"}).error;
    EXPECT_NE(error.find("holds no scan with only=top; it has scans of front, rear ("), std::string::npos)
        << error;
  }
}

TEST(OpenRecordingTest, WhatTheSensorSaysOfItselfComesBackWhereTheFormatHasIt) {
  std::vector<LaserScan> scans = made_scans(3);
  scans[1].health = {.severity = 2, .is_polluted = true};
  for (const char* name : {"x.jsonl", "x.mcap"}) {
    const Reading reading = read_all(recorded(name, scans), name);
    ASSERT_EQ(reading.scans.size(), 3U) << name << ": " << reading.error;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(reading.scans[i].health, scans[i].health) << name << i;
  }
}

TEST(OpenRecordingTest, MetadataComesBackWhereTheFormatHasIt) {
  const RecordingMetadata metadata = {{"seed", "7"}, {"configuration", "a: \"b\"\nc: {}\n"}};
  for (const char* name : {"x.jsonl", "x.mcap", "x.player"}) {
    EXPECT_EQ(read_all(recorded(name, made_scans(1), metadata), name).metadata, metadata) << name;
  }
}

// Metadata stands before the first scan, and may be long.
TEST(OpenRecordingTest, LongCommentsDoNotHideAFormat) {
  std::string text;
  for (int i = 0; i < 400; ++i) text += "a line of a scenario file\n";
  for (const char* name : {"x.player", "x.log"}) {
    const Reading reading = read_all(recorded(name, made_scans(2), {{"configuration", text}}), "no_ending");
    EXPECT_EQ(reading.scans.size(), 2U) << name << ": " << reading.error;
  }
}

TEST(OpenRecordingTest, RefusesNamesOfNoFormat) {
  const TemporaryFolder folder;
  EXPECT_THROW(create_recording(folder / "x.txt", {}), InputError);
  EXPECT_THROW(create_recording(folder / "x.bag.gz", {}), InputError);
  EXPECT_THROW(create_recording(folder / "x.log.part", {}), InputError);
}

TEST(OpenRecordingTest, RefusesWhatIsNotThereOrEmpty) {
  EXPECT_THROW(open_recording("/nowhere/x.mcap", {}, {}), InputError);
  for (const char* name : {"x.jsonl", "x.mcap", "x.bag", "x.log", "x.player", "x"}) {
    EXPECT_NE(read_all("", name).error, "") << name;
    EXPECT_NE(read_all(tests::gzip(""), name).error, "") << name;
  }
  for (const char* name : {"x.jsonl", "x.mcap", "x.bag", "x.log", "x.player"}) {
    EXPECT_NE(read_all(recorded(name, {}), name).error, "") << name << " without scans";
  }
}

TEST(OpenRecordingTest, RefusesBadOptions) {
  EXPECT_THROW(open_recording(from_memory("x"), "x", {.no_return_m = 0.0}, {}), InputError);
}

// Scans of 0 and 1 beams are scans.
TEST(OpenRecordingTest, TinyScansComeBack) {
  for (const int num_beams : {0, 1, 2}) {
    LaserScan scan = made_scan(1);
    scan.geometry.num_beams = num_beams;
    scan.range_m.resize(static_cast<std::size_t>(num_beams));
    for (const char* name : {"x.jsonl", "x.mcap", "x.bag", "x.log", "x.player"}) {
      const Reading reading = read_all(recorded(name, {scan}), name);
      ASSERT_EQ(reading.scans.size(), 1U) << name << num_beams << ": " << reading.error;
      EXPECT_TRUE(same_ranges(reading.scans[0], scan)) << name << num_beams;
    }
  }
}

// The formats that keep everything keep any doubles.
RC_GTEST_PROP(OpenRecordingTest, AnyRangesComeBackToTheBit, (const std::vector<float>& values)) {
  LaserScan scan;
  for (const float value : values) {
    const double range_m = std::abs(static_cast<double>(value)) / 3.0;
    scan.range_m.push_back(range_m);
  }
  scan.geometry.num_beams = scan.num_beams();
  scan.geometry.step_rad = kPi / 3.0 / std::max(scan.num_beams(), 1);
  scan.time_s = values.empty() ? 0.0 : std::min(std::abs(static_cast<double>(values[0])), 1e9);
  for (const char* name : {"x.jsonl", "x.mcap"}) {
    const Reading reading = read_all(recorded(name, {scan}), name);
    RC_ASSERT(reading.scans.size() == 1U);
    RC_ASSERT(same_ranges(reading.scans[0], scan));
    RC_ASSERT(reading.scans[0].geometry.step_rad == scan.geometry.step_rad);
    RC_ASSERT(reading.scans[0].time_s == scan.time_s);
  }
}

}  // namespace
}  // namespace scanbed::hw
