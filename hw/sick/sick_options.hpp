// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/scan/lms_word.hpp"
#include "core/scan/scan_geometry.hpp"
#include "hw/sick/lms_variant.hpp"

namespace scanbed::hw {

/// How long the driver waits for what. The defaults suit every LMS 2xx; tests shorten them.
struct SickPatience {
  double ack_s = 0.25;     ///< for the first sign of an answer
  double reply_s = 3.5;    ///< for the answer, once there was a sign; a change of mode takes up to 3 s
  double write_s = 25.0;   ///< for the answer to a configuration that is written
  double settle_s = 0.3;   ///< after a change of baud
  double silence_s = 1.0;  ///< without a good telegram in the stream, beside its time on the wire
  double pause_s = 0.5;    ///< between two attempts to get the sensor back
  double close_s = 0.07;   ///< for an answer while the driver stops
  double boot_s = 60.0;    ///< before the first scan, from the sensor's first sign: it may be starting anew
  int num_first_attempts =
      3;  ///< before the sensor's first sign; after the first scan there is no end of them
};

/// What `sick:PATH?...` says.
struct SickOptions {
  std::string path;   ///< of the serial port
  int baud = 38400;   ///< at which to stream
  int fov_deg = 180;  ///< 180 or 100
  int resolution_cdeg =
      50;  ///< hundredths of a degree: 100, 50 or 25; 25 at 180 degrees interlaces four turns
  RangeUnit unit = RangeUnit::kMillimetre;
  std::optional<int> measuring_mode;  ///< empty: leave the sensor's own
  bool restore_baud = true;           ///< on close go back to the baud that the sensor was found at
  int max_waiting = 64;               ///< scans kept for a reader that is busy; then the oldest are dropped
  bool is_lossless = false;  ///< rather let the port wait than drop scans: for emulators, which can wait too
  SickPatience patience;

  LmsVariant variant() const { return {fov_deg, resolution_cdeg}; }
  /// Whether turns of the mirror are streamed one by one and put together here.
  bool is_interlaced_here() const { return fov_deg == 180 && resolution_cdeg == 25; }
  void validate() const;  ///< @throws InputError naming the first field out of range
};

/// Beams of the scans to come. The mirror turns in 13.32 ms and measures a beam a degree, so that beam i is
/// measured i / num_rotations degrees into its turn.
ScanGeometry sick_geometry(const SickOptions& options, const LmsWordFormat& format);

}  // namespace scanbed::hw
