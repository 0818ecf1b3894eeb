// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/angles.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

TEST(LoadSensorTest, DefaultsToTheLms200AsThePaperRunsIt) {
  const Scenario scenario = parse("sensor: {use: sick_lms200}\n");
  EXPECT_DOUBLE_EQ(scenario.lms.step_rad, radians(0.5));
  EXPECT_DOUBLE_EQ(scenario.lms.fov_rad, radians(180.0));
  EXPECT_DOUBLE_EQ(scenario.lms.scan_period_s, 0.2);
  EXPECT_DOUBLE_EQ(scenario.world.robot.laser_height_m, 0.28);
}

TEST(LoadSensorTest, TakesEveryKey) {
  const Scenario scenario = parse(
      "sensor: {use: sick_lms200, resolution_deg: 1, fov_deg: 100, unit: cm, link: rs422_500k, height: 0.5, "
      "noise: {sigma: 0.01}, interlace: false}\n");
  EXPECT_DOUBLE_EQ(scenario.lms.step_rad, radians(1.0));
  EXPECT_DOUBLE_EQ(scenario.lms.fov_rad, radians(100.0));
  EXPECT_EQ(scenario.lms.unit, sim::RangeUnit::kCentimetre);
  EXPECT_DOUBLE_EQ(scenario.lms.scan_period_s, 1.0 / 37.5);
  EXPECT_DOUBLE_EQ(scenario.world.robot.laser_height_m, 0.5);
  EXPECT_DOUBLE_EQ(scenario.lms.noise_sigma_m, 0.01);
  EXPECT_FALSE(scenario.lms.interlace);
}

TEST(LoadSensorTest, RefusesSettingsThatTheSensorDoesNotHave) {
  EXPECT_EQ(parse_error("sensor: {resolution_deg: 0.3}\n"),
            "f:4:26: resolution_deg: the sensor has no such setting; allowed: 0.25, 0.5, 1");
  EXPECT_EQ(parse_error("sensor: {fov_deg: 270}\n"),
            "f:4:19: fov_deg: the sensor has no such setting; allowed: 100, 180");
  EXPECT_EQ(parse_error("sensor: {link: rs422_38k}\n"),
            "f:4:16: link: unknown value 'rs422_38k'; did you mean 'rs422_38400'?");
  EXPECT_EQ(parse_error("sensor: {use: hokuyo}\n"),
            "f:4:15: use: unknown value 'hokuyo'; known values: sick_lms200");
  EXPECT_EQ(parse_error("sensor: {noise: {sigma: -1}}\n"),
            "f:4:25: sigma: value -1 is out of range; allowed: [0, 0.5]");
  EXPECT_EQ(parse_error("sensor: {hieght: 0.3}\n"), "f:4:10: unknown key 'hieght'; did you mean 'height'?");
  EXPECT_EQ(parse_error("sensor: {height: 0}\n"), "f:4:18: height: value 0 is out of range; allowed: (0, 2]");
}

}  // namespace
}  // namespace scanbed::scenarios
