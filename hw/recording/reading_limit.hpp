// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/scan/laser_scan.hpp"

namespace scanbed::hw {

/// What logs of text hold for a beam without echo where the laser's maximum range is not known: more than an
/// LMS 2xx can say.
inline constexpr double kNoReturnReading_m = 81.91;

/// The maximum range to write beside a scan's readings. From it on they mean "no return", so it lies beyond
/// all ranges, rounded to `resolution_m`.
inline double reading_limit_m(const LaserScan& scan, double resolution_m) {
  const bool is_known = std::isfinite(scan.geometry.max_range_m);
  double limit_m = is_known ? scan.geometry.max_range_m : kNoReturnReading_m;
  for (const double range_m : scan.range_m) {
    if (std::isfinite(range_m) && range_m + resolution_m / 2 >= limit_m)
      limit_m = range_m + resolution_m + 0.001;
  }
  return limit_m;
}

}  // namespace scanbed::hw
