// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// What beams see in a gap of a wall.
enum class GapView {
  kUnknown,  ///< too few beams, or they disagree
  kHidden,   ///< something nearer stands before it
  kRecess,   ///< a surface a little behind the wall: a closed door in its frame
  kOpen,     ///< beams go on well behind the wall
};

/// A straight wall as an infinite line: normal * p = distance_m, the normal points away from the sensor.
struct WallPlane {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double distance_m = 0.0;
};

/// The line through both ends of a piece.
WallPlane plane_through(const Line& line);

/// @param beams  those inside the gap, both included; fewer than 3 say nothing. In a scan all around they may
///               go on behind the last one, with the first one again.
GapView gap_view(const LaserScan& scan, const BeamSpan& beams, const WallPlane& plane);

}  // namespace scanbed
