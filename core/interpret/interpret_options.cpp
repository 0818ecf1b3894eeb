// SPDX-License-Identifier: MIT
#include "core/interpret/interpret_options.hpp"

#include "core/errors/input_error.hpp"

namespace scanbed {

void InterpretOptions::validate() const {
  require(min_wall_m >= 0.0 && min_wall_m <= 100.0, "interpret.min_wall_m", min_wall_m, "[0, 100]");
  require(wall_offset_m > 0.0 && wall_offset_m <= 1.0, "interpret.wall_offset_m", wall_offset_m, "(0, 1]");
  require(max_wall_gap_m >= 0.0 && max_wall_gap_m <= 100.0, "interpret.max_wall_gap_m", max_wall_gap_m,
          "[0, 100]");
  require(min_corner_rad > 0.0 && min_corner_rad <= kPi / 2, "interpret.min_corner_rad", min_corner_rad,
          "(0, 1.5708]");
  require(corner_reach_m > 0.0 && corner_reach_m <= 10.0, "interpret.corner_reach_m", corner_reach_m,
          "(0, 10]");
  require(min_door_m > 0.0 && min_door_m <= 10.0, "interpret.min_door_m", min_door_m, "(0, 10]");
  require(max_door_m > min_door_m && max_door_m <= 10.0, "interpret.max_door_m", max_door_m,
          "(min_door_m, 10]");
  require(bench_gap_m > 0.0 && bench_gap_m <= 10.0, "interpret.bench_gap_m", bench_gap_m, "(0, 10]");
  require(bench_tolerance_m > 0.0 && bench_tolerance_m <= 1.0, "interpret.bench_tolerance_m",
          bench_tolerance_m, "(0, 1]");
  require(max_bench_radius_m > 0.0 && max_bench_radius_m <= 10.0, "interpret.max_bench_radius_m",
          max_bench_radius_m, "(0, 10]");
  require(min_trash_can_radius_m >= 0.0 && min_trash_can_radius_m <= 10.0, "interpret.min_trash_can_radius_m",
          min_trash_can_radius_m, "[0, 10]");
  require(max_trash_can_radius_m >= min_trash_can_radius_m && max_trash_can_radius_m <= 10.0,
          "interpret.max_trash_can_radius_m", max_trash_can_radius_m, "[min_trash_can_radius_m, 10]");
}

}  // namespace scanbed
