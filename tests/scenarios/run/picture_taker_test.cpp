// SPDX-License-Identifier: MIT
#include "scenarios/run/picture_taker.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

// Two seconds at 5 Hz: scans at 0, 0.2, ... 1.8 s.
Scenario ten_scans(const std::string& pictures = "{}") {
  return testing::parse("world: [{id: c, cylinder: {at: [2, 0], r: 0.3}}]\noutputs: {pictures: " + pictures +
                        "}\n");
}

LaserScan scan_at(double time_s) {
  LaserScan scan;
  scan.time_s = time_s;
  return scan;
}

TEST(ShowsTest, GivesAMomentToTheLastScanThatStartsByThen) {
  const Scenario scenario = ten_scans();
  EXPECT_TRUE(shows(scenario, scan_at(0.0), 0.0));
  EXPECT_TRUE(shows(scenario, scan_at(0.0), 0.19));
  EXPECT_FALSE(shows(scenario, scan_at(0.0), 0.2));
  EXPECT_FALSE(shows(scenario, scan_at(0.2 * 2 + 0.2 - 1e-12), 0.8));  // 0.6 s with the sum's error
  EXPECT_TRUE(shows(scenario, scan_at(0.2 * 3), 0.6));
}

TEST(ShowsTest, GivesTheEndToTheLastScan) {
  const Scenario scenario = ten_scans();
  EXPECT_FALSE(shows(scenario, scan_at(1.6), 2.0));
  EXPECT_TRUE(shows(scenario, scan_at(1.8), 2.0));
}

TEST(CaptionTest, SaysWhichMomentOfWhichRun) {
  EXPECT_EQ(caption(ten_scans(), scan_at(0.4)), "test  seed 1  t = 0.4 s");
}

TEST(PictureTakerTest, PaintsWhatTheScenarioAsksFor) {
  const testing::TemporaryFolder folder;
  const Scenario scenario = ten_scans("{top: [0, 0.5, 2], laser: [1]}");
  sim::SimulatedLms sensor(scenario.world,
                           {.lms = scenario.lms, .duration_s = scenario.duration_s, .seed = scenario.seed});
  PictureTaker pictures(scenario, sensor, folder.path());
  LaserScan scan;
  while (sensor.next(scan, RangeSensor::Seconds{0.0})) pictures.see(scan, {});
  const std::vector<std::filesystem::path> expected = {
      folder / "test_top_0s.png", folder / "test_top_0.5s.png", folder / "test_laser_1s.png",
      folder / "test_top_2s.png"};
  EXPECT_EQ(pictures.files(), expected);
  for (const std::filesystem::path& file : expected) {
    EXPECT_EQ(testing::read_file(file).substr(1, 3), "PNG") << file;
  }
}

}  // namespace
}  // namespace scanbed::scenarios
