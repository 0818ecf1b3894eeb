// SPDX-License-Identifier: MIT
#include "scenarios/command/run_one.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

RunCommand simulated() {
  RunCommand command;
  command.laser = parse_laser_spec("sim");
  return command;
}

TEST(RunOneTest, RunsAndScoresWithItsPreset) {
  const Scenario scenario = testing::parse(
      "world: [{id: c, cylinder: {at: [2, 0], r: 0.3}}]\nscore: {circle: {need: {recall: 0.9}}}\n");
  FeatureDetector detector(robust_options());
  const Processing processing{detector, {}, "robust"};
  const RunAndPictures done = run_one(simulated(), {scenario.name, scenario, processing, {}});
  EXPECT_EQ(done.result.num_scans, 10);
  EXPECT_EQ(done.result.laser, "sim");
  EXPECT_EQ(done.result.preset, "robust");
  EXPECT_TRUE(done.result.met_its_gates());
  EXPECT_TRUE(done.pictures.empty());
}

TEST(RunOneTest, ReportsWhatTheScriptDrivesIntoEachOther) {
  // The robot's front, 0.22 m ahead, reaches the column's at x = 0.7 after 0.48 m: 0.96 s.
  const Scenario scenario = testing::parse(
      "robot: {speed: 0.5, drive: [{go: 2}]}\nworld: [{id: c, cylinder: {at: [1, 0], r: 0.3}}]\n");
  FeatureDetector detector(robust_options());
  const Processing processing{detector};
  for (const sim::Backend backend : {sim::Backend::kPlanar, sim::Backend::kSpatial}) {
    RunCommand command = simulated();
    command.backend = backend;
    const RunAndPictures done = run_one(command, {scenario.name, scenario, processing, {}});
    ASSERT_EQ(done.result.collisions.size(), 1u);
    EXPECT_EQ(done.result.collisions[0].first, "robot");
    EXPECT_EQ(done.result.collisions[0].second, "c");
    EXPECT_NEAR(done.result.collisions[0].time_s, 0.96, 0.1);
  }
}

TEST(RunOneTest, PaintsWhereItHasAFolder) {
  const testing::TemporaryFolder folder;
  const Scenario scenario = testing::parse("outputs: {pictures: {top: [1]}}\n");
  FeatureDetector detector(robust_options());
  const Processing processing{detector};
  const RunAndPictures done = run_one(simulated(), {scenario.name, scenario, processing, folder.path()});
  ASSERT_EQ(done.pictures.size(), 1u);
  EXPECT_TRUE(std::filesystem::exists(done.pictures[0]));
}

}  // namespace
}  // namespace scanbed::scenarios
