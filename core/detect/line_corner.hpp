// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/detect/features.hpp"
#include "core/geometry/angles.hpp"
#include "core/scan/scan_geometry.hpp"

namespace scanbed {

/// When two pieces of walls make a corner.
struct CornerLimits {
  double min_angle_rad = radians(30.0);  ///< between the walls, at least
  double reach_m = 0.15;                 ///< their ends lie so near to it
};

/// Two pieces of walls, one after the other.
struct NeighbouringLines {
  const Line& a;
  const Line& b;
  BeamSpan between;  ///< beams of neither, none (first > last) where they touch; past a seam they count on
};

/// Where both lines meet, if that is at the end of a and the beginning of b, as far as the beams tell: where
/// these are far apart, or graze a wall, its corner may be far from its last echo.
std::optional<Eigen::Vector2d> corner_of(const NeighbouringLines& lines, const ScanGeometry& geometry,
                                         const CornerLimits& limits = {});

/// Lets lines that make a corner end there.
/// @param lines  they rise in beams.first.
void end_at_corners(std::vector<Line>& lines, const ScanGeometry& geometry);

}  // namespace scanbed
