// SPDX-License-Identifier: MIT
#include "core/track/track_options.hpp"

#include "core/errors/input_error.hpp"

namespace scanbed {

void TrackOptions::validate() const {
  require(gate_m > 0.0 && gate_m <= 10.0, "track.gate_m", gate_m, "(0, 10]");
  require(gate_speed_m_per_s >= 0.0 && gate_speed_m_per_s <= 100.0, "track.gate_speed_m_per_s",
          gate_speed_m_per_s, "[0, 100]");
  require(max_gate_m >= gate_m && max_gate_m <= 10.0, "track.max_gate_m", max_gate_m, "[gate_m, 10]");
  require(num_confirming_hits >= 1 && num_confirming_hits <= 1000, "track.num_confirming_hits",
          num_confirming_hits, "[1, 1000]");
  require(num_coasted_scans >= 0 && num_coasted_scans <= 1000, "track.num_coasted_scans", num_coasted_scans,
          "[0, 1000]");
  require(max_hidden_s >= 0.0 && max_hidden_s <= 1000.0, "track.max_hidden_s", max_hidden_s, "[0, 1000]");
  require(evidence_keep_ratio >= 0.0 && evidence_keep_ratio < 1.0, "track.evidence_keep_ratio",
          evidence_keep_ratio, "[0, 1)");
  require(displacement_window_s > 0.0 && displacement_window_s <= 100.0, "track.displacement_window_s",
          displacement_window_s, "(0, 100]");
  require(displacement_step_m > 0.0 && displacement_step_m <= 100.0, "track.displacement_step_m",
          displacement_step_m, "(0, 100]");
  require(max_displacement_evidence >= 0.0 && max_displacement_evidence <= 100.0,
          "track.max_displacement_evidence", max_displacement_evidence, "[0, 100]");
  require(max_leg_distance_m > 0.0 && max_leg_distance_m <= 2.0, "track.max_leg_distance_m",
          max_leg_distance_m, "(0, 2]");
  require(thin_circle_score >= 0.0 && thin_circle_score <= 1.0, "track.thin_circle_score", thin_circle_score,
          "[0, 1]");
  require(min_score >= 0.0 && min_score <= 1.0, "track.min_score", min_score, "[0, 1]");
  require(min_cylinder_radius_m >= 0.0 && min_cylinder_radius_m <= 10.0, "track.min_cylinder_radius_m",
          min_cylinder_radius_m, "[0, 10]");
  require(max_cylinder_radius_m > min_cylinder_radius_m && max_cylinder_radius_m <= 100.0,
          "track.max_cylinder_radius_m", max_cylinder_radius_m, "(min_cylinder_radius_m, 100]");
  require(mobile_distance_m > 0.0 && mobile_distance_m <= 10.0, "track.mobile_distance_m", mobile_distance_m,
          "(0, 10]");
}

}  // namespace scanbed
