// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/angles.hpp"

namespace scanbed {

/// When a detection counts as the truth that it is compared with.
struct MatchOptions {
  double line_angle_rad = radians(3.0);  ///< between the detected line and the wall
  double line_offset_m = 0.05;           ///< of the detected line's middle across the wall
  double line_overlap_ratio =
      0.5;  ///< of the visible piece that lines must cover, and of a line that lies on walls
  double circle_center_m = 0.10;
  double circle_radius_m = 0.05;
  double leg_center_m = 0.15;
  double narrow_cylinder_m =
      0.125;                ///< a leg on a true cylinder of smaller radius is neither right nor wrong
  double person_m = 0.5;    ///< between a track and the middle of a person
  double cylinder_m = 0.5;  ///< between a track and a cylinder
  void validate() const;    ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed
