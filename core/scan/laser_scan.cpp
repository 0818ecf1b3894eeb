// SPDX-License-Identifier: MIT
#include "core/scan/laser_scan.hpp"

namespace scanbed {

double range_towards(const LaserScan& scan, double bearing_rad) {
  const double beam = std::floor(scan.geometry.beam_towards(bearing_rad) + 0.5);
  if (!(beam >= 0.0 && beam < scan.num_beams())) return kNoEcho;
  return scan.range_m[static_cast<std::size_t>(beam)];
}

}  // namespace scanbed
