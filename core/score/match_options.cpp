// SPDX-License-Identifier: MIT
#include "core/score/match_options.hpp"

#include "core/errors/input_error.hpp"

namespace scanbed {

void MatchOptions::validate() const {
  require(line_angle_rad > 0.0 && line_angle_rad <= kPi / 2, "match.line_angle_rad", line_angle_rad,
          "(0, 1.5708]");
  require(line_offset_m > 0.0 && line_offset_m <= 10.0, "match.line_offset_m", line_offset_m, "(0, 10]");
  require(line_overlap_ratio > 0.0 && line_overlap_ratio <= 1.0, "match.line_overlap_ratio",
          line_overlap_ratio, "(0, 1]");
  require(circle_center_m > 0.0 && circle_center_m <= 10.0, "match.circle_center_m", circle_center_m,
          "(0, 10]");
  require(circle_radius_m > 0.0 && circle_radius_m <= 10.0, "match.circle_radius_m", circle_radius_m,
          "(0, 10]");
  require(leg_center_m > 0.0 && leg_center_m <= 10.0, "match.leg_center_m", leg_center_m, "(0, 10]");
  require(person_m > 0.0 && person_m <= 10.0, "match.person_m", person_m, "(0, 10]");
  require(cylinder_m > 0.0 && cylinder_m <= 10.0, "match.cylinder_m", cylinder_m, "(0, 10]");
  require(narrow_cylinder_m >= 0.0 && narrow_cylinder_m <= 10.0, "match.narrow_cylinder_m", narrow_cylinder_m,
          "[0, 10]");
}

}  // namespace scanbed
