// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/scan/scan_geometry.hpp"

namespace scanbed::hw {

/// When a telegram was complete, as far as reading the port tells.
struct TelegramArrival {
  double read_s = 0.0;
  std::size_t num_bytes_behind = 0;  ///< that were read together with it and stand behind it
};

/// When the first beam of a scan was measured, from when its telegram was complete: the telegram's time on
/// the wire lies between, and the scan itself. What an adapter holds bytes back for (16 ms at most, with the
/// usual settings of USB ones) is not known, and makes times late by as much.
class ScanClock {
 public:
  /// @param is_paced  false for a sensor that runs ahead of the time on the wall: an emulator without pauses.
  explicit ScanClock(int baud, bool is_paced = true) : byte_s_(10.0 / baud), is_paced_(is_paced) {}

  /// Of a sensor that is not paced, scans are as far apart as turns of the mirror and the wire would make
  /// them.
  ///
  /// Telegrams that were read together arrived one after another: each scan takes its turns of the mirror,
  /// and its telegram the wire, before the next can be there. A part of a telegram counts as much as has come
  /// of it. Where that is more than there was time for since the last scan, they share what there was. Times
  /// never go back: a scan that seems to be from before the last one gets the last one's time.
  /// @param num_bytes  of its telegram.
  /// @returns not less than 0, where no arrival is from before the sensor could have sent a telegram since 0.
  double first_beam_s(const TelegramArrival& arrival, std::size_t num_bytes, const ScanGeometry& geometry);

 private:
  double byte_s_;
  bool is_paced_;
  bool is_first_ = true;
  double last_s_ = 0.0;
};

}  // namespace scanbed::hw
