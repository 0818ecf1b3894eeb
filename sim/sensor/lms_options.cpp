// SPDX-License-Identifier: MIT
#include "sim/sensor/lms_options.hpp"

#include <cmath>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

constexpr double kTolerance_rad = 1e-9;  // degrees come as rounded radians

bool is_near(double a_rad, double b_rad) {
  return std::abs(a_rad - b_rad) <= kTolerance_rad;
}

}  // namespace

int LmsOptions::num_rotations() const {
  return interlace ? static_cast<int>(std::lround(radians(1.0) / step_rad)) : 1;
}

int LmsOptions::num_beams() const {
  return static_cast<int>(std::lround(fov_rad / step_rad)) + 1;
}

void LmsOptions::validate() const {
  const bool offered =
      is_near(step_rad, radians(0.25)) || is_near(step_rad, radians(0.5)) || is_near(step_rad, radians(1.0));
  require(offered, "lms.step_deg", degrees(step_rad), "0.25, 0.5 or 1");
  require(fov_rad > 0.0 && fov_rad <= kPi + kTolerance_rad, "lms.fov_deg", degrees(fov_rad), "(0, 180]");
  require(is_near(fov_rad, (num_beams() - 1) * step_rad), "lms.fov_deg", degrees(fov_rad),
          "a multiple of lms.step_deg");
  require(noise_sigma_m >= 0.0 && noise_sigma_m <= 1.0, "lms.noise_sigma_m", noise_sigma_m, "[0, 1]");
  require(rotation_s > 0.0 && rotation_s <= 10.0, "lms.rotation_s", rotation_s, "(0, 10]");
  const double sweep_s = num_rotations() * rotation_s;
  require(scan_period_s >= sweep_s * (1.0 - 1e-9) && scan_period_s <= 3600.0, "lms.scan_period_s",
          scan_period_s,
          std::to_string(sweep_s) + " (" + std::to_string(num_rotations()) + " rotations) to 3600");
}

}  // namespace scanbed::sim
