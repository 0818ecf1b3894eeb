// SPDX-License-Identifier: MIT
#include "hw/sick/scan_clock.hpp"

#include <algorithm>
#include <utility>

namespace scanbed::hw {

double ScanClock::first_beam_s(const TelegramArrival& arrival, std::size_t num_bytes,
                               const ScanGeometry& geometry) {
  const double wire_s = static_cast<double>(num_bytes) * byte_s_;
  // The last turn of the mirror ends the scan.
  const BeamTiming& timing = geometry.timing;
  const double last_turn_s = timing.step_s * (geometry.num_beams - 1) / timing.num_rotations;
  const double scan_s = (timing.num_rotations - 1) * timing.rotation_s + last_turn_s;
  const double latest_s = arrival.read_s - wire_s - scan_s;
  const double period_s = timing.num_rotations * timing.rotation_s;
  if (!is_paced_) {
    last_s_ =
        std::exchange(is_first_, false) ? latest_s : std::max(latest_s, last_s_ + std::max(period_s, wire_s));
    return last_s_;
  }
  const std::size_t num_whole_behind = arrival.num_bytes_behind / num_bytes;
  const std::size_t num_part_bytes = arrival.num_bytes_behind % num_bytes;
  const double behind_s = static_cast<double>(num_whole_behind) * std::max(period_s, wire_s) +
                          static_cast<double>(num_part_bytes) * byte_s_;
  const double num_behind = static_cast<double>(arrival.num_bytes_behind) / static_cast<double>(num_bytes);
  const double share_s = std::max(0.0, latest_s - last_s_) / (num_behind + 1.0);
  last_s_ = std::max(last_s_ + std::min(period_s, share_s), latest_s - behind_s);
  return last_s_;
}

}  // namespace scanbed::hw
