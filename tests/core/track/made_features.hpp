// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed::testing {

/// A scan in which nothing hides anything: all echoes come from far behind.
inline LaserScan open_scan(double time_s, double range_m = 20.0) {
  LaserScan scan;
  scan.time_s = time_s;
  scan.range_m.assign(scan.geometry.num_beams, range_m);
  return scan;
}

inline Leg leg_at(const Eigen::Vector2d& p_SL_m, double score = 0.9) {
  return {.middle_m = p_SL_m, .score = score};
}

inline Circle circle_at(const Eigen::Vector2d& p_SC_m, double radius_m) {
  return {.center_m = p_SC_m, .radius_m = radius_m, .score = 0.95};
}

}  // namespace scanbed::testing
