// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// What a scan says of a place.
enum class PlaceView {
  kOutOfView,  ///< no beam points there
  kHidden,     ///< something nearer stands before it
  kOccupied,   ///< something is there
  kEmpty,      ///< beams pass through it
};

/// Looks at a place of the sensor frame through the beams that meet the middle half of a disc of the given
/// radius around it, and says what most of them say: that they end before it, in it, or behind it.
PlaceView view_of(const LaserScan& scan, const Eigen::Vector2d& p_m, double radius_m);

/// How many echoes lie within a radius of a place of the sensor frame; 0 where the sensor itself does.
int num_echoes_near(const LaserScan& scan, const Eigen::Vector2d& p_m, double radius_m);

}  // namespace scanbed
