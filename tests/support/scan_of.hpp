// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "core/scan/laser_scan.hpp"

namespace scanbed::testing {

/// A scan of as many beams as there are ranges; otherwise of the default geometry.
inline LaserScan scan_of(std::vector<double> range_m) {
  LaserScan scan;
  scan.geometry.num_beams = static_cast<int>(range_m.size());
  scan.range_m = std::move(range_m);
  return scan;
}

}  // namespace scanbed::testing
