// SPDX-License-Identifier: MIT
#include "scenarios/command/open_laser.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/scenarios/run_program.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

TEST(OpenScenarioTest, LetsTheSeedBeReplaced) {
  const testing::TemporaryFolder folder;
  const std::string file = testing::write_file(folder / "a.yaml", testing::kHead + "seed: 3\n").string();
  EXPECT_EQ(open_scenario(file, {}, std::nullopt).seed, 3u);
  EXPECT_EQ(open_scenario(file, {}, 9).seed, 9u);
}

TEST(SimulateTest, GivesAScanAPeriodUntilTheEnd) {
  const auto sensor = simulate(testing::parse(""));
  LaserScan scan;
  int num_scans = 0;
  while (sensor->next(scan, RangeSensor::Seconds{0.0})) ++num_scans;
  EXPECT_EQ(num_scans, 10);  // two seconds at 5 Hz
}

TEST(OpenLogTest, ReadsARecording) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "a.log", testing::flaser({"1.0", "2.0"}));
  const auto log = open_log(parse_laser_spec("log:" + file.string()));
  LaserScan scan;
  ASSERT_TRUE(log->next(scan, RangeSensor::Seconds{0.0}));
  EXPECT_EQ(scan.num_beams(), 2);
}

TEST(CountsTest, ReadAsASentence) {
  EXPECT_EQ(to_text({.num_scans = 1, .num_damaged_lines = 0, .num_other_lines = 2}),
            "1 scan, 0 damaged lines, 2 other lines");
}

TEST(SortSettingsTest, SendsTableTwosNamesToTheDetector) {
  const std::array<Setting, 3> settings = {Setting{"line_err", "0.1"}, Setting{"seed", "3"},
                                           Setting{"world.line_err.r", "1"}};
  const SortedSettings sorted = sort_settings(settings);
  ASSERT_EQ(sorted.detector.size(), 1u);
  EXPECT_EQ(sorted.detector[0].path, "line_err");
  EXPECT_EQ(sorted.scenario.size(), 2u);
}

}  // namespace
}  // namespace scanbed::scenarios
