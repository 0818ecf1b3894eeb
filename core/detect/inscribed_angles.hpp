// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/detect/chord.hpp"

namespace scanbed {

/// Mean and standard deviation of the angles under which a segment's inner points see its two ends.
struct InscribedAngles {
  double average_rad = 0.0;
  double std_rad = 0.0;
};

/// How a point behind the chord counts, as seen from the sensor.
enum class BehindChord {
  /// By its angle above 180 degrees: those of a line jitter around 180 and average to it.
  kReflex,
  /// By the angle below 180 degrees under which it sees the chord, like a point in front. On an arc only
  /// noise
  /// puts points there, next to the ends, where the reflex angle would say that they fit worst of all.
  kFolded,
};

/// Angle P1-P-P4 of one point: 180 degrees on the chord, smaller on the sensor's side; [0, 2 pi).
double inscribed_angle_rad(const Chord& chord, const Eigen::Vector2d& p_SQ, BehindChord behind);

/// Inscribed angle variance: on an arc all inscribed angles are equal, on a line they are 180 degrees.
///
/// @returns empty for segments of fewer than 3 points, which have no inner point.
/// @par Cost    O(n).
/// @par Source  The paper, II-B, eq. 1.
std::optional<InscribedAngles> inscribed_angles(const Points& points, const Segment& segment,
                                                BehindChord behind);

/// Whether the inscribed angles grow on both sides of their smallest one, two points each way: a corner and
/// no arc.
///
/// A minimum nearer than two inner points to an end has not four neighbours, and is no corner.
/// @par Source  The paper, II-B.3 and fig. 4.
bool is_v_corner(const Points& points, const Segment& segment);

}  // namespace scanbed
