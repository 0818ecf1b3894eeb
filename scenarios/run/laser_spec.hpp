// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "hw/recording/open_recording.hpp"
#include "hw/recording/paced_replay.hpp"

namespace scanbed::scenarios {

enum class LaserKind { kSimulated, kLog };

/// Where scans come from: what `--laser` says.
struct LaserSpec {
  LaserKind kind = LaserKind::kSimulated;
  std::string text = "sim";  ///< as it was written
  std::string target;        ///< kSimulated: a scenario, or empty for the one that runs; kLog: a file
  hw::RecordingOptions log;  ///< kLog
  hw::ReplayOptions replay;  ///< kLog
};

/// Parses "sim", "sim:SCENARIO" or "log:FILE?only=FLASER&no_return=81.83&speed=1&from=2&to=10".
///
/// @throws InputError for an unknown kind or option, with the nearest known one; for values that do not fit;
///                    and for sick: and player:, which this version does not have yet.
LaserSpec parse_laser_spec(std::string_view text);

}  // namespace scanbed::scenarios
