// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "hw/cola/cola_laser.hpp"
#include "hw/recording/open_recording.hpp"
#include "hw/recording/paced_replay.hpp"
#include "hw/scip/scip_laser.hpp"
#include "hw/sick/sick_options.hpp"

namespace scanbed::scenarios {

enum class LaserKind { kSimulated, kLog, kSick, kScip, kCola };

/// Where scans come from: what `--laser` says.
struct LaserSpec {
  LaserKind kind = LaserKind::kSimulated;
  std::string text = "sim";  ///< as it was written
  std::string target;        ///< kSimulated: a scenario, or empty for the one that runs; kLog: a file
  hw::RecordingOptions log;  ///< kLog
  hw::ReplayOptions replay;  ///< kLog
  hw::SickOptions sick;      ///< kSick
  hw::ScipOptions scip;      ///< kScip
  hw::ColaOptions cola;      ///< kCola

  bool is_device() const { return kind != LaserKind::kSimulated && kind != LaserKind::kLog; }
};

/// Parses "sim", "sim:SCENARIO", "log:FILE?only=FLASER&no_return=81.83&speed=1&from=2&to=10",
/// "sick:PORT?baud=38400&fov_deg=180&resolution_deg=0.5&unit=mm&mode=0&lossless=0",
/// "scip:PORT?baud=115200", "scip:HOST[:10940]" or "cola:HOST[:2111]".
///
/// @throws InputError for an unknown kind or option, with the nearest known one; for values that do not fit;
///                    and for player:, which this version does not have yet.
LaserSpec parse_laser_spec(std::string_view text);

}  // namespace scanbed::scenarios
