// SPDX-License-Identifier: MIT
#include "sim/sensor/lms_options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

TEST(LmsOptionsTest, DefaultsAreValid) {
  EXPECT_NO_THROW(LmsOptions{}.validate());
}

TEST(LmsOptionsTest, KnowTheLasersModes) {
  LmsOptions options;
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

TEST(LmsOptionsTest, ScansMayFollowEachOtherWithoutAPause) {
  LmsOptions options;
  options.scan_period_s = 2.0 / 75;
  EXPECT_NO_THROW(options.validate());
}

void expect_named(const LmsOptions& options, const std::string& field) {
  try {
    options.validate();
    ADD_FAILURE() << "accepted: " << field;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(field + ": value ", 0), 0U) << error.what();
  }
}

TEST(LmsOptionsTest, EachBadFieldIsNamed) {
  const double nan = std::nan("");
  for (const double step_deg : {0.0, -0.5, 0.3, 2.0, nan}) {
    expect_named({.step_rad = radians(step_deg)}, "lms.step_deg");
  }
  for (const double fov_deg : {0.0, -90.0, 270.0, 100.2, nan}) {
    expect_named({.fov_rad = radians(fov_deg)}, "lms.fov_deg");
  }
  for (const double sigma_m : {-0.001, 1.1, nan})
    expect_named({.noise_sigma_m = sigma_m}, "lms.noise_sigma_m");
  for (const double rotation_s : {0.0, -1.0, 11.0, nan})
    expect_named({.rotation_s = rotation_s}, "lms.rotation_s");
  for (const double period_s : {0.0, 0.02, 1e9, nan}) {
    expect_named({.scan_period_s = period_s}, "lms.scan_period_s");
  }
}

}  // namespace
}  // namespace scanbed::sim
