// SPDX-License-Identifier: MIT
#include "hw/sick/scan_clock.hpp"

#include <algorithm>

namespace scanbed::hw {

double ScanClock::first_beam_s(double arrival_s, std::size_t num_bytes, const ScanGeometry& geometry) {
  const double wire_s = static_cast<double>(num_bytes) * byte_s_;
  // The last turn of the mirror ends the scan.
  const BeamTiming& timing = geometry.timing;
  const double last_turn_s = timing.step_s * (geometry.num_beams - 1) / timing.num_rotations;
  const double scan_s = (timing.num_rotations - 1) * timing.rotation_s + last_turn_s;
  last_s_ = std::max(last_s_, arrival_s - wire_s - scan_s);
  return last_s_;
}

}  // namespace scanbed::hw
