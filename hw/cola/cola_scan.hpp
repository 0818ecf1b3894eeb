// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scan/laser_scan.hpp"

namespace scanbed::hw {

/// One row of values of an LMDscandata telegram.
struct ColaChannel {
  std::string name;  ///< DIST1, DIST2, RSSI1, ...
  float scale = 1.0F;
  float offset = 0.0F;
  std::int32_t first_angle = 0;  ///< ten-thousandths of a degree; 90 degrees is ahead
  std::uint32_t step = 0;        ///< ten-thousandths of a degree
  std::vector<std::uint32_t> values;
};

/// What an LMDscandata telegram says, as far as scans need it.
struct ColaScan {
  std::uint32_t status = 0;  ///< second status byte: 0 fine, 1 error, 2 pollution warning, 5 pollution error
  std::uint32_t start_us = 0;       ///< since power-up, of the scan's start; wraps
  std::uint32_t sent_us = 0;        ///< by the same counter, of the telegram's transmission
  std::uint32_t frequency_chz = 0;  ///< hundredths of a hertz
  std::vector<ColaChannel> channels;

  /// From the scan's start to the telegram's transmission: a real TiM takes 4 ms. 0 where the telegram does
  /// not tell, that is, where it would be more than a second.
  double age_s() const;
};

/// Reads "sSN LMDscandata ..." or "sRA LMDscandata ...". What stands behind the channels is not looked at,
/// and may be missing.
///
/// @returns empty where it is none, or is cut off before the end of its channels.
/// @par Source  SICK, "Telegram listing: Ranging sensors LMS1xx, LMS5xx, TiM5xx ...", 8014631. Checked
/// against
///              telegrams of real TiM and LMS sensors; no sensor was at hand.
std::optional<ColaScan> parse_cola_scan(std::string_view body);

/// First echo to metres, in the sensor frame: 0 degrees of the device lies to the right. Values below 16 are
/// codes or nothing, so they are without echo.
/// @returns false where there is no channel DIST1, or its beams cannot be.
bool to_laser_scan(const ColaScan& telegram, LaserScan& scan);

}  // namespace scanbed::hw
