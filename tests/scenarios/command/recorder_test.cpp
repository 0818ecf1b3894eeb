// SPDX-License-Identifier: MIT
#include "scenarios/command/recorder.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"
#include "hw/recording/open_recording.hpp"
#include "scenarios/command/open_laser.hpp"
#include "tests/scenarios/run_program.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

TEST(RecorderTest, RecordsScansWithFeaturesAndTruth) {
  const testing::TemporaryFolder folder;
  const auto sensor = simulate(testing::parse(""));
  Recorder recorder(folder / "x.jsonl", {{"seed", "7"}});
  LaserScan scan;
  while (sensor->next(scan, RangeSensor::Seconds{0.0})) recorder.see(scan, {}, *sensor);
  recorder.finish();
  const auto reader = hw::open_recording(folder / "x.jsonl", {}, {});
  EXPECT_EQ(reader->metadata().at("seed"), "7");
  int num_scans = 0;
  while (reader->next(scan, {})) {
    ++num_scans;
    EXPECT_NE(reader->features(), nullptr);
    ASSERT_NE(reader->truth(), nullptr);
    EXPECT_EQ(reader->truth()->beams.size(), scan.range_m.size());
  }
  EXPECT_EQ(num_scans, 10);
}

TEST(RecorderTest, WithoutAFileDoesNothing) {
  const auto sensor = simulate(testing::parse(""));
  Recorder recorder(std::nullopt, {});
  recorder.see({}, {}, *sensor);
  EXPECT_NO_THROW(recorder.finish());
}

TEST(RecorderTest, RefusesAnUnknownEnding) {
  EXPECT_THROW(Recorder("/tmp/x.txt", {}), InputError);
}

TEST(RecorderTest, MetadataHoldsSeedAndConfiguration) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "a.yaml", testing::kHead + "seed: 3\n");
  hw::RecordingMetadata metadata = recording_metadata("sim", "paper");
  add_scenario(metadata, file.string(), 9);
  EXPECT_EQ(metadata.at("laser"), "sim");
  EXPECT_EQ(metadata.at("seed"), "9");
  EXPECT_EQ(metadata.at("configuration"), testing::kHead + "seed: 3\n");
}

}  // namespace
}  // namespace scanbed::scenarios
