// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/angles.hpp"
#include "core/scan/lms_word.hpp"

namespace scanbed::sim {

using scanbed::RangeUnit;

/// The simulated SICK LMS 200. Every effect can be switched off.
struct LmsOptions {
  double fov_rad = radians(180.0);
  double step_rad = radians(0.5);           ///< 0.25, 0.5 or 1 degree
  RangeUnit unit = RangeUnit::kMillimetre;  ///< step of a range; also sets the greatest: 8.183 or 81.83 m
  double noise_sigma_m = 0.005;             ///< Gaussian, of each range
  double scan_period_s = 0.2;               ///< between scans: 5 Hz is what a 38400 baud link carries
  bool interlace = true;                    ///< odd beams are measured one rotation later
  double rotation_s = 1.0 / 75.0;           ///< of the mirror

  int num_beams() const;
  int num_rotations() const;  ///< interlaced into one scan: one per degree / step, or 1 without interlace
  void validate() const;      ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed::sim
