// SPDX-License-Identifier: MIT
#include "scenarios/load/sensor_effects.hpp"

#include <gtest/gtest.h>

#include "core/geometry/angles.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

TEST(SensorEffectsTest, KeepTheirPresetsValuesUnlessTold) {
  const sim::SensorOptions told = parse("sensor: {bias: {dark: 0.02}}\n").lms;
  EXPECT_EQ(told.bias.dark_m, 0.02);
  EXPECT_EQ(told.bias.cyclic_m, parse("").lms.bias.cyclic_m);
  EXPECT_GT(told.bias.cyclic_m, 0.0);
}

TEST(SensorEffectsTest, TakeEveryKey) {
  const sim::SensorOptions s =
      parse(
          "sensor:\n"
          "  noise: {sigma: 0.01, sigma_ratio: 0.002, weak_ratio: 0.1}\n"
          "  bias: {offset: 0.01, cyclic: 0.002, cyclic_period: 2.5, dark: 0.003, grazing: 0.004}\n"
          "  spot: {diameter: 0.02, divergence_deg: 0.5, rays: 9, pulse: 0.7}\n"
          "  dropout: {reach: 6, glass_cone_deg: 3}\n"
          "  dazzle: {probability: 0.01, glint_deg: 0.2}\n"
          "  effects: {noise: 0.5, bias: 2, spot: 1.5, dropout: 0, dazzle: 3, sweep: 0}\n")
          .lms;
  EXPECT_EQ(s.noise_sigma_m, 0.01);
  EXPECT_EQ(s.noise.sigma_ratio, 0.002);
  EXPECT_EQ(s.noise.weak_ratio, 0.1);
  EXPECT_EQ(s.bias.offset_m, 0.01);
  EXPECT_EQ(s.bias.cyclic_m, 0.002);
  EXPECT_EQ(s.bias.cyclic_period_m, 2.5);
  EXPECT_EQ(s.bias.dark_m, 0.003);
  EXPECT_EQ(s.bias.grazing_m, 0.004);
  EXPECT_EQ(s.spot.diameter_m, 0.02);
  EXPECT_DOUBLE_EQ(s.spot.divergence_rad, radians(0.5));
  EXPECT_EQ(s.spot.num_rays, 9);
  EXPECT_EQ(s.spot.pulse_m, 0.7);
  EXPECT_EQ(s.dropout.reach_m, 6.0);
  EXPECT_DOUBLE_EQ(s.dropout.glass_cone_rad, radians(3.0));
  EXPECT_EQ(s.dazzle.probability, 0.01);
  EXPECT_DOUBLE_EQ(s.dazzle.glint_rad, radians(0.2));
  EXPECT_EQ(s.effects.noise, 0.5);
  EXPECT_EQ(s.effects.bias, 2.0);
  EXPECT_EQ(s.effects.spot, 1.5);
  EXPECT_EQ(s.effects.dropout, 0.0);
  EXPECT_EQ(s.effects.dazzle, 3.0);
  EXPECT_EQ(s.effects.sweep, 0.0);
}

TEST(SensorEffectsTest, RefuseWhatNoSensorHas) {
  EXPECT_EQ(parse_error("sensor: {spot: {rays: 4}}\n"),
            "f:4:23: rays: expected an odd number: the middle ray is the beam's axis");
  EXPECT_EQ(parse_error("sensor: {effects: {sweep: 0.5}}\n"),
            "f:4:27: sweep: expected a whole number, found 0.5");
  EXPECT_EQ(parse_error("sensor: {dazzle: {probability: 2}}\n"),
            "f:4:32: probability: value 2 is out of range; allowed: [0, 1]");
  EXPECT_EQ(parse_error("sensor: {bias: {greasing: 2}}\n"),
            "f:4:17: unknown key 'greasing'; did you mean 'grazing'?");
}

}  // namespace
}  // namespace scanbed::scenarios
