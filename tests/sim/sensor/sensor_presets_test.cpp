// SPDX-License-Identifier: MIT
#include "sim/sensor/sensor_presets.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

TEST(SensorPresetsTest, EveryPresetValidates) {
  ASSERT_EQ(sensor_preset_names().size(), 6U);
  for (const std::string& name : sensor_preset_names())
    EXPECT_NO_THROW(sensor_preset(name).validate()) << name;
}

// Beams, rate and limits that the data sheets state.
TEST(SensorPresetsTest, SensorsHaveTheBeamsOfTheirDataSheets) {
  struct Sheet {
    const char* name;
    int num_beams;
    double rate_hz, min_range_m, max_range_m;
  };
  for (const Sheet& sheet : {Sheet{"sick_lms200", 361, 5.0, 0.0, 8.182},
                             {"hokuyo_urg04lx", 683, 10, 0.06, 4.095},
                             {"hokuyo_utm30lx", 1081, 40, 0.1, 30},
                             {"rplidar_a1", 360, 5.5, 0.15, 12},
                             {"sick_tim5xx", 811, 15, 0.05, 10}}) {
    const SensorOptions sensor = sensor_preset(sheet.name);
    EXPECT_EQ(sensor.num_beams(), sheet.num_beams) << sheet.name;
    EXPECT_NEAR(1.0 / sensor.scan_period_s, sheet.rate_hz, 1e-9) << sheet.name;
    EXPECT_EQ(sensor.min_range_m, sheet.min_range_m) << sheet.name;
    EXPECT_EQ(sensor.range_limit_m(), sheet.max_range_m) << sheet.name;
  }
}

// Systematic error of the LMS 200: at most 15 mm. Of the TiM561: 60 mm.
TEST(SensorPresetsTest, PartsOfTheBiasAddUpToTheStatedError) {
  for (const auto& [name, stated_m] : {std::pair{"sick_lms200", 0.015}, std::pair{"sick_tim5xx", 0.060}}) {
    const BiasOptions bias = sensor_preset(name).bias;
    EXPECT_NEAR(bias.offset_m + bias.cyclic_m + bias.dark_m + bias.grazing_m, stated_m, 1e-12) << name;
  }
}

TEST(SensorPresetsTest, TheIdealSensorHasTheBeamsOfTheLms200) {
  const SensorOptions ideal = sensor_preset("ideal");
  EXPECT_EQ(ideal.num_beams(), 361);
  EXPECT_TRUE(ideal.exact_ranges);
}

TEST(SensorPresetsTest, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  try {
    sensor_preset("velodyne");
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'velodyne'"), std::string::npos) << message;
    for (const std::string& name : sensor_preset_names()) EXPECT_NE(message.find(name), std::string::npos);
  }
}

}  // namespace
}  // namespace scanbed::sim
