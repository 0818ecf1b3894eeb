// SPDX-License-Identifier: MIT
#include "sim/sensor/sensor_options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

TEST(SensorOptionsTest, DefaultsAreValid) {
  EXPECT_NO_THROW(SensorOptions{}.validate());
}

TEST(SensorOptionsTest, KnowTheLasersModes) {
  SensorOptions options;
  EXPECT_EQ(options.num_beams(), 361);
  EXPECT_EQ(options.num_rotations(), 2);
  options.step_rad = radians(1.0);
  EXPECT_EQ(options.num_beams(), 181);
  EXPECT_EQ(options.num_rotations(), 1);
  options.step_rad = radians(0.25);
  options.fov_rad = radians(100.0);
  EXPECT_EQ(options.num_beams(), 401);
  EXPECT_EQ(options.num_rotations(), 4);
  EXPECT_NO_THROW(options.validate());
  options.interlace = false;
  EXPECT_EQ(options.num_rotations(), 1);
}

TEST(SensorOptionsTest, ScansMayFollowEachOtherWithoutAPause) {
  SensorOptions options;
  options.scan_period_s = 2.0 / 75;
  EXPECT_NO_THROW(options.validate());
}

void expect_named(const SensorOptions& options, const std::string& field) {
  try {
    options.validate();
    ADD_FAILURE() << "accepted: " << field;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(field + ": value ", 0), 0U) << error.what();
  }
}

TEST(SensorOptionsTest, EachBadFieldIsNamed) {
  const double nan = std::nan("");
  for (const double step_deg : {0.0, -0.5, 0.3, 2.0, nan}) {
    expect_named({.step_rad = radians(step_deg)}, "sensor.step_deg");
  }
  for (const double step_deg : {0.0, -1.0, 11.0, nan}) {
    expect_named({.step_rad = radians(step_deg), .interlace = false}, "sensor.step_deg");
  }
  for (const double fov_deg : {0.0, -90.0, 370.0, 100.2, nan}) {
    expect_named({.fov_rad = radians(fov_deg)}, "sensor.fov_deg");
  }
  for (const double rotation_s : {0.0, -1.0, 11.0, nan})
    expect_named({.rotation_s = rotation_s}, "sensor.rotation_s");
  for (const double period_s : {0.0, 0.02, 1e9, nan}) {
    expect_named({.scan_period_s = period_s}, "sensor.scan_period_s");
  }
  expect_named({.word_bits = 12}, "sensor.word_bits");
  expect_named({.word_bits = 16}, "sensor.word_bits");
  expect_named({.min_range_m = 8.2}, "sensor.min_range_m");  // farther than 13 bits reach
  expect_named({.min_range_m = -0.1}, "sensor.min_range_m");
  for (const double far_m : {0.0, -1.0, nan}) expect_named({.max_range_m = far_m}, "sensor.max_range_m");
  expect_named({.max_sector_s = 0.0}, "sensor.max_sector_s");
}

TEST(SensorOptionsTest, EachBadFigureOfAnEffectIsNamed) {
  const double nan = std::nan("");
  for (const double sigma_m : {-0.001, 1.1, nan})
    expect_named({.noise_sigma_m = sigma_m}, "sensor.noise_sigma_m");
  expect_named({.noise = {.sigma_ratio = -0.1}}, "sensor.noise.sigma_ratio");
  expect_named({.noise = {.weak_ratio = nan}}, "sensor.noise.weak_ratio");
  expect_named({.bias = {.offset_m = 2}}, "sensor.bias.offset_m");
  expect_named({.bias = {.cyclic_m = nan}}, "sensor.bias.cyclic_m");
  expect_named({.bias = {.cyclic_period_m = 0}}, "sensor.bias.cyclic_period_m");
  expect_named({.bias = {.dark_m = -2}}, "sensor.bias.dark_m");
  expect_named({.bias = {.grazing_m = nan}}, "sensor.bias.grazing_m");
  expect_named({.spot = {.diameter_m = -0.01}}, "sensor.spot.diameter_m");
  expect_named({.spot = {.divergence_rad = 1}}, "sensor.spot.divergence_rad");
  for (const int rays : {1, 2, 6, 11}) expect_named({.spot = {.num_rays = rays}}, "sensor.spot.num_rays");
  expect_named({.spot = {.pulse_m = nan}}, "sensor.spot.pulse_m");
  expect_named({.dropout = {.reach_m = 0}}, "sensor.dropout.reach_m");
  expect_named({.dropout = {.glass_cone_rad = 2}}, "sensor.dropout.glass_cone_rad");
  expect_named({.dazzle = {.probability = 1.5}}, "sensor.dazzle.probability");
  expect_named({.dazzle = {.glint_rad = -1}}, "sensor.dazzle.glint_rad");
  expect_named({.effects = {.noise = -1}}, "sensor.effects.noise");
  expect_named({.effects = {.bias = nan}}, "sensor.effects.bias");
  expect_named({.effects = {.spot = 11}}, "sensor.effects.spot");
  expect_named({.effects = {.dropout = -1}}, "sensor.effects.dropout");
  expect_named({.effects = {.dazzle = -1}}, "sensor.effects.dazzle");
  expect_named({.effects = {.sweep = 0.5}}, "sensor.effects.sweep");
}

TEST(SensorOptionsTest, ThreeHundredAndSixtyDegreesAreAllowedWithoutInterlace) {
  const SensorOptions round{.fov_rad = radians(359.0), .step_rad = radians(1.0), .interlace = false};
  EXPECT_NO_THROW(round.validate());
  EXPECT_EQ(round.num_beams(), 360);
}

// 361 ranges are 732 bytes: 190.6 ms at 38400 baud, and at 500 kbaud the mirror is the slower: 37.5 Hz.
TEST(SensorOptionsTest, TheLinkSetsTheRateUntilTheMirrorDoes) {
  SensorOptions options;
  EXPECT_EQ(lms_telegram_bytes(361), 732);
  EXPECT_EQ(lms_telegram_bytes(181), 372);
  EXPECT_EQ(lms_telegram_bytes(401), 812);
  EXPECT_NEAR(lms_scan_period_s(options, 38400.0), 0.1906, 5e-5);
  EXPECT_NEAR(1.0 / lms_scan_period_s(options, 500000.0), 37.5, 1e-9);
  EXPECT_NEAR(lms_scan_period_s(options, 9600.0), 7320.0 / 9600.0, 1e-12);
  options.step_rad = radians(1.0);
  EXPECT_NEAR(1.0 / lms_scan_period_s(options, 500000.0), 75.0, 1e-9);
  EXPECT_THROW(lms_scan_period_s(options, 0.0), InputError);
  EXPECT_THROW(lms_scan_period_s(options, std::nan("")), InputError);
}

TEST(SensorOptionsTest, BeamsOfARotationFollowEachOtherAsTheMirrorTurns) {
  SensorOptions options;
  EXPECT_NEAR(options.beam_period_s(), 1.0 / 75 / 360, 1e-15);  // one degree, at any resolution
  options.step_rad = radians(0.25);
  EXPECT_NEAR(options.beam_period_s(), 1.0 / 75 / 360, 1e-15);
  options.effects.sweep = 0.0;
  EXPECT_EQ(options.beam_period_s(), 0.0);
}

TEST(SensorOptionsTest, TheSpotWidensWithRangeAndScales) {
  SensorOptions options;
  EXPECT_EQ(options.spot_diameter_m(4.0), 0.0);
  options.spot = {.diameter_m = 0.014, .divergence_rad = 0.0044};
  EXPECT_NEAR(options.spot_diameter_m(4.0), 0.0316, 1e-12);  // published: 32 mm
  options.effects.spot = 0.5;
  EXPECT_NEAR(options.spot_diameter_m(4.0), 0.0158, 1e-12);
}

TEST(SensorOptionsTest, WithoutEffectsEveryScaleIsZeroAndTheBeamsStay) {
  const SensorOptions ideal = ideal_sensor({.step_rad = radians(0.25), .min_range_m = 0.1});
  EXPECT_TRUE(ideal.exact_ranges);
  EXPECT_EQ(ideal.num_rotations(), 1);
  EXPECT_EQ(ideal.num_beams(), 721);
  EXPECT_EQ(ideal.min_range_m, 0.1);
  for (const double scale : {ideal.effects.noise, ideal.effects.bias, ideal.effects.spot,
                             ideal.effects.dropout, ideal.effects.dazzle, ideal.effects.sweep}) {
    EXPECT_EQ(scale, 0.0);
  }
  EXPECT_NO_THROW(ideal.validate());
}

}  // namespace
}  // namespace scanbed::sim
