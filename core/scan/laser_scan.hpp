// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/scan/scan_geometry.hpp"

namespace scanbed {

// What a beam says when it has no range (REP 117).
inline constexpr double kNoEcho = std::numeric_limits<double>::infinity();
inline constexpr double kTooClose = -std::numeric_limits<double>::infinity();
inline constexpr double kInvalid = std::numeric_limits<double>::quiet_NaN();

/// What a sensor says of itself beside its ranges. A scan is given all the same: how far to trust it is for
/// the user to decide.
struct SensorHealth {
  int severity = 0;             ///< 0 fine, 1 note, 2 warning, 3 error, 4 fatal
  bool is_polluted = false;     ///< its window wants cleaning
  bool is_implausible = false;  ///< it doubts its own values

  friend bool operator==(const SensorHealth&, const SensorHealth&) = default;
};

/// One sweep of a range sensor: all that a detector may know.
struct LaserScan {
  std::int64_t index = 0;  ///< counts the scans of the source from 0
  double time_s = 0.0;     ///< of the first beam, on the source's clock
  ScanGeometry geometry;   ///< of this scan; a recording may change it from scan to scan
  std::vector<double>
      range_m;  ///< geometry.num_beams of them, > 0; kNoEcho, kTooClose or kInvalid where there is none
  std::optional<Pose2> X_OR;  ///< robot in the odometry frame, where the source knows it
  std::string source;         ///< which laser, where the source has several ("FLASER"); else empty
  SensorHealth health;        ///< as far as the source tells; fine by default

  int num_beams() const { return static_cast<int>(range_m.size()); }
  bool has_echo(int beam) const { return range_m[beam] > 0.0 && std::isfinite(range_m[beam]); }
};

/// Range of the beam that points nearest to a bearing, sensor frame S; kNoEcho where none points there.
double range_towards(const LaserScan& scan, double bearing_rad);

}  // namespace scanbed
