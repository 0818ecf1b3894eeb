// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/line_corner.hpp"

namespace scanbed {

/// What is known of the architecture beforehand.
struct InterpretOptions {
  double min_wall_m = 0.4;      ///< straight pieces that together are shorter are no wall
  double wall_offset_m = 0.05;  ///< pieces of one wall lie so near to its line
  double max_wall_gap_m = 3.0;  ///< pieces of one wall are no farther apart
  double min_corner_rad = CornerLimits{}.min_angle_rad;  ///< between the walls of a corner, at least
  double corner_reach_m = CornerLimits{}.reach_m;        ///< their ends lie so near to it
  double min_door_m = 0.6;                               ///< narrower gaps in a wall are no doors
  double max_door_m = 2.5;                               ///< wider ones neither
  double bench_gap_m = 1.2;                              ///< between the middles of a bench's feet
  double bench_tolerance_m = 0.06;                       ///< by which that may be off
  double max_bench_radius_m = 0.35;                      ///< of a foot
  double min_trash_can_radius_m = 0.12;                  ///< thinner round things are columns
  double max_trash_can_radius_m = 0.19;                  ///< thicker ones likewise
  void validate() const;  ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed
