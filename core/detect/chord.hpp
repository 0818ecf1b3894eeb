// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/detect/points.hpp"
#include "core/detect/segmentation.hpp"

namespace scanbed {

/// The chord of a segment: from its first point P1 to its last point P4, and the side on which the sensor is.
struct Chord {
  Eigen::Vector2d from_m;     ///< P1
  Eigen::Vector2d to_m;       ///< P4
  double length_m = 0.0;      ///< d(P1, P4)
  Eigen::Vector2d to_sensor;  ///< unit normal of the chord, towards the sensor; zero where length_m is 0

  /// Distance of a point from the chord's line, positive on the sensor's side.
  double depth_m(const Eigen::Vector2d& p_SQ) const { return (p_SQ - from_m).dot(to_sensor); }
};

Chord chord_of(const Points& points, const Segment& segment);

/// Whether the segment bulges towards the sensor as an arc does: the depth of its middle point below the
/// chord lies between the two ratios of the chord's length.
///
/// @par Source  The paper, II-D, eq. 2 to 4. Rotating the chord onto an axis is the same as measuring along
/// its normal. Departs: of two points in the middle the deeper one counts, whichever way the beams turn.
bool bulges_like_an_arc(const Points& points, const Segment& segment, double min_depth_ratio,
                        double max_depth_ratio);

}  // namespace scanbed
