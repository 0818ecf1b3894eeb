// SPDX-License-Identifier: MIT
#include "hw/sick/scan_clock.hpp"

#include <algorithm>

namespace scanbed::hw {

double ScanClock::first_beam_s(double arrival_s, std::size_t num_bytes, const ScanGeometry& geometry) {
  const double wire_s = static_cast<double>(num_bytes) * byte_s_;
  const double scan_s = geometry.timing.offset_s(geometry.num_beams - 1);
  const double last_of_turn_s = (geometry.timing.num_rotations - 1) * geometry.timing.rotation_s;
  last_s_ = std::max(last_s_, arrival_s - wire_s - std::max(scan_s, last_of_turn_s));
  return last_s_;
}

}  // namespace scanbed::hw
