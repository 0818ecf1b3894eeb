// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/detect/points.hpp"
#include "core/geometry/pose2.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/track/scan_matcher.hpp"

namespace scanbed {

/// Where the sensor's motion is taken from.
enum class MotionSource {
  kAuto,      ///< scans are matched; odometry, where it ever moves, says where to begin and stands in
  kScans,     ///< scans are matched, odometry is not looked at
  kOdometry,  ///< odometry alone; a source without it counts as standing still
  kStill,     ///< the sensor stands still
};

/// In the order of the values.
inline constexpr std::array<std::string_view, 4> kMotionSourceWords = {"auto", "scans", "odometry", "still"};

/// Follows the sensor through a world frame W that is the sensor's own at the first scan. Scans are compared
/// with a reference scan that changes only when the sensor has moved on, so that a sensor that stands does
/// not drift.
class EgoMotion {
 public:
  explicit EgoMotion(MotionSource source = MotionSource::kAuto) : source_(source) {}

  void set_source(MotionSource source) { source_ = source; }

  /// The sensor's pose X_WS at this scan.
  /// @par Cost  with matching, some 0.1 to 0.2 ms for 361 beams.
  const Pose2& update(const LaserScan& scan);

  /// X_WS at the latest scan.
  const Pose2& pose() const { return X_WS_; }

 private:
  Pose2 odometry_step(const LaserScan& scan);
  bool match(const LaserScan& scan, const Pose2& expected_X_WS);
  void begin_reference(const LaserScan& scan);

  MotionSource source_;
  PointProjector projector_;
  Points points_;
  ScanMatcher matcher_;
  bool has_begun_ = false;
  Pose2 X_WS_;
  Pose2 X_WA_;       ///< of the reference scan
  Pose2 last_step_;  ///< sensor's motion between the last two scans
  double last_time_s_ = 0.0;
  double last_dt_s_ = 0.0;  ///< in which last_step_ was made
  std::optional<Pose2> last_X_OR_;
  bool odometry_moves_ = false;
};

}  // namespace scanbed
