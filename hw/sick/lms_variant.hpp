// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/scan/lms_word.hpp"

namespace scanbed::hw {

/// Time of one turn of the mirror. In one turn the LMS measures a beam a degree; finer scans interlace turns.
inline constexpr double kLmsRotation_s = 0.01332;

/// Field of view and resolution, in the units of the wire.
struct LmsVariant {
  int fov_deg = 180;         ///< 180 or 100
  int resolution_cdeg = 50;  ///< hundredths of a degree: 100, 50 or 25

  friend bool operator==(const LmsVariant&, const LmsVariant&) = default;

  int num_beams() const { return fov_deg * 100 / resolution_cdeg + 1; }
  int num_rotations() const { return 100 / resolution_cdeg; }
  /// Whether the sensor can be set to it: all combinations but 180 degrees at 0.25.
  bool is_offered() const;
};

/// What the stream of a sensor is to carry.
struct LmsStreamSettings {
  LmsVariant variant;
  RangeUnit unit = RangeUnit::kMillimetre;
};

/// Bauds that an LMS 2xx knows, slowest first: 9600, 19200, 38400, 500000.
inline constexpr int kLmsBauds[] = {9600, 19200, 38400, 500000};
inline constexpr std::string_view kLmsBaudNames = "9600, 19200, 38400, 500000";

bool is_lms_baud(std::int64_t baud);

}  // namespace scanbed::hw
