// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/scan/laser_scan.hpp"
#include "core/scan/lms_word.hpp"

namespace scanbed::hw {

/// An LMS in centimetres: its readings from the first on are overflow codes, and there is none beyond the
/// last. That is what logs of text hold for a beam without echo where the maximum range is not known.
inline constexpr double kFirstLmsCode_m = kLmsBeyondMax / 100.0;    // 81.83
inline constexpr double kLastLmsCode_m = kLmsNoStopSignal / 100.0;  // 81.91

/// The maximum range to write beside a scan's readings. From it on they mean "no return", so it lies beyond
/// all ranges, rounded to `resolution_m`.
inline double reading_limit_m(const LaserScan& scan, double resolution_m) {
  const bool is_known = std::isfinite(scan.geometry.max_range_m);
  double limit_m = is_known ? scan.geometry.max_range_m : kLastLmsCode_m;
  for (const double range_m : scan.range_m) {
    if (std::isfinite(range_m) && range_m + resolution_m / 2 >= limit_m)
      limit_m = range_m + resolution_m + 0.001;
  }
  return limit_m;
}

}  // namespace scanbed::hw
