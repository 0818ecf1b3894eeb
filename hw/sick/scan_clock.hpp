// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/scan/scan_geometry.hpp"

namespace scanbed::hw {

/// When the first beam of a scan was measured, from when its telegram was complete: the telegram's time on
/// the wire lies between, and the scan itself. What an adapter holds bytes back for (16 ms at most, with the
/// usual settings of USB ones) is not known, and makes times late by as much.
class ScanClock {
 public:
  explicit ScanClock(int baud) : byte_s_(10.0 / baud) {}

  /// Times never go back: a scan that seems to be from before the last one gets the last one's time.
  double first_beam_s(double arrival_s, std::size_t num_bytes, const ScanGeometry& geometry);

 private:
  double byte_s_;
  double last_s_ = -1e300;
};

}  // namespace scanbed::hw
