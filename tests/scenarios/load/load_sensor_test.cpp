// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/angles.hpp"
#include "sim/sensor/sensor_presets.hpp"
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
            "f:4:15: use: unknown value 'hokuyo'; known values: sick_lms200, hokuyo_urg04lx, hokuyo_utm30lx, "
            "rplidar_a1, "
            "sick_tim5xx, ideal");
  EXPECT_EQ(parse_error("sensor: {noise: {sigma: -1}}\n"),
            "f:4:25: sigma: value -1 is out of range; allowed: [0, 0.5]");
  EXPECT_EQ(parse_error("sensor: {hieght: 0.3}\n"), "f:4:10: unknown key 'hieght'; did you mean 'height'?");
  EXPECT_EQ(parse_error("sensor: {height: 0}\n"), "f:4:18: height: value 0 is out of range; allowed: (0, 2]");
}

TEST(LoadSensorTest, HasEveryPresetWithAllItsEffects) {
  const sim::SensorOptions urg = parse("sensor: {use: hokuyo_urg04lx, noise: {sigma: 0.004}}\n").lms;
  const sim::SensorOptions preset = sim::sensor_preset("hokuyo_urg04lx");
  EXPECT_EQ(urg.num_beams(), preset.num_beams());
  EXPECT_EQ(urg.scan_period_s, preset.scan_period_s);
  EXPECT_EQ(urg.bias.dark_m, preset.bias.dark_m);
  EXPECT_EQ(urg.noise.sigma_ratio, preset.noise.sigma_ratio);
  EXPECT_EQ(urg.noise_sigma_m, 0.004);
  EXPECT_TRUE(parse("sensor: {use: ideal}\n").lms.exact_ranges);
  EXPECT_GT(parse("").lms.spot.divergence_rad, 0.0) << "the LMS 200 as it is, also where nothing is said";
}

TEST(LoadSensorTest, RefusesFiguresOfEffectsThatTheSensorDoesNotHave) {
  EXPECT_NE(
      parse_error("sensor: {use: ideal, noise: {sigma: 0.1}}\n")
          .find("noise: changes nothing: this sensor has no such effect; write effects: {noise: 1} too"),
      std::string::npos);
  EXPECT_EQ(parse("sensor: {use: ideal, noise: {sigma: 0.1}, effects: {noise: 1}}\n").lms.effects.noise, 1.0);
  // Who switches it off again knows what he does.
  EXPECT_EQ(parse("sensor: {noise: {sigma: 0.1}, effects: {noise: 0}}\n").lms.effects.noise, 0.0);
}

TEST(LoadSensorTest, LetsSensorsWithoutInterlaceDifferFromTheirPreset) {
  const sim::SensorOptions tim =
      parse(
          "sensor: {use: sick_tim5xx, resolution_deg: 0.5, fov_deg: 200.2, period: 0.1, min_range: 0.2, "
          "max_range: 4}\n")
          .lms;
  EXPECT_DOUBLE_EQ(tim.step_rad, radians(0.5));
  EXPECT_NEAR(tim.fov_rad, radians(200.0), 1e-12) << "a whole number of steps";
  EXPECT_EQ(tim.scan_period_s, 0.1);
  EXPECT_EQ(tim.min_range_m, 0.2);
  EXPECT_EQ(tim.max_range_m, 4.0);
  EXPECT_EQ(parse_error("sensor: {period: 0.01}\n").substr(0, 36), "f:4:18: period: value 0.01 is out of");
  EXPECT_EQ(parse_error("sensor: {link: rs422_500k, period: 1}\n"),
            "f:4:36: period: the link says already how often there are scans");
}

TEST(LoadSensorTest, SeesNoFartherThanItsWordsTell) {
  EXPECT_EQ(parse_error("sensor: {max_range: 30}\n"),
            "f:4:21: max_range: 30 m are more than this sensor's words can tell; allowed: up to 8.182 m, or "
            "unit: cm");
  EXPECT_EQ(parse("sensor: {max_range: 30, unit: cm}\n").lms.max_range_m, 30.0);
  EXPECT_EQ(parse("sensor: {max_range: 5}\n").lms.max_range_m, 5.0);
}

TEST(LoadSensorTest, ScansNoFasterThanTheMirrorTurnsOrTheLinkCarries) {
  // A quarter of a degree takes four rotations of 1/75 s; 401 beams are 812 bytes of ten bits.
  const std::string fine = "resolution_deg: 0.25, fov_deg: 100";
  EXPECT_DOUBLE_EQ(parse("sensor: {" + fine + ", link: rs422_500k}\n").lms.scan_period_s, 4.0 / 75.0);
  EXPECT_DOUBLE_EQ(parse("sensor: {" + fine + ", link: rs422_38400}\n").lms.scan_period_s, 8120.0 / 38400.0);
}

TEST(LoadSensorTest, MountsTheLaserTilted) {
  const Scenario scenario = parse("sensor: {pitch_deg: 10, roll_deg: -5}\n");
  EXPECT_DOUBLE_EQ(scenario.world.robot.laser_pitch_rad, radians(10.0));
  EXPECT_DOUBLE_EQ(scenario.world.robot.laser_roll_rad, radians(-5.0));
  EXPECT_EQ(parse_error("sensor: {pitch_deg: 90}\n"),
            "f:4:21: pitch_deg: value 90 is out of range; allowed: [-80, 80]");
}

TEST(LoadSensorTest, PutsFaultsOfThePartsTogetherAtTheSensor) {
  EXPECT_EQ(parse_error("sensor: {min_range: 9}\n").substr(0, 27), "f:4:9: sensor.min_range_m: ");
}

}  // namespace
}  // namespace scanbed::scenarios
