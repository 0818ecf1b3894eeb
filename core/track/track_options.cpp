// SPDX-License-Identifier: MIT
#include "core/track/track_options.hpp"

#include "core/errors/input_error.hpp"

namespace scanbed {

namespace {

void validate_gates(const TrackOptions& o) {
  require(o.gate_m > 0.0 && o.gate_m <= 10.0, "track.gate_m", o.gate_m, "(0, 10]");
  require(o.gate_speed_m_per_s >= 0.0 && o.gate_speed_m_per_s <= 100.0, "track.gate_speed_m_per_s",
          o.gate_speed_m_per_s, "[0, 100]");
  require(o.max_gate_m >= o.gate_m && o.max_gate_m <= 10.0, "track.max_gate_m", o.max_gate_m, "[gate_m, 10]");
  require(o.num_confirming_hits >= 1 && o.num_confirming_hits <= 1000, "track.num_confirming_hits",
          o.num_confirming_hits, "[1, 1000]");
  require(o.num_coasted_scans >= 0 && o.num_coasted_scans <= 1000, "track.num_coasted_scans",
          o.num_coasted_scans, "[0, 1000]");
  require(o.max_hidden_s >= 0.0 && o.max_hidden_s <= 1000.0, "track.max_hidden_s", o.max_hidden_s,
          "[0, 1000]");
  require(o.max_lost_s >= 0.0 && o.max_lost_s <= 1000.0, "track.max_lost_s", o.max_lost_s, "[0, 1000]");
}

void validate_evidence(const TrackOptions& o) {
  require(o.evidence_keep_ratio >= 0.0 && o.evidence_keep_ratio < 1.0, "track.evidence_keep_ratio",
          o.evidence_keep_ratio, "[0, 1)");
  require(o.displacement_window_s > 0.0 && o.displacement_window_s <= 100.0, "track.displacement_window_s",
          o.displacement_window_s, "(0, 100]");
  require(o.displacement_step_m > 0.0 && o.displacement_step_m <= 100.0, "track.displacement_step_m",
          o.displacement_step_m, "(0, 100]");
  require(o.max_displacement_evidence >= 0.0 && o.max_displacement_evidence <= 100.0,
          "track.max_displacement_evidence", o.max_displacement_evidence, "[0, 100]");
  require(o.max_leg_distance_m > 0.0 && o.max_leg_distance_m <= 2.0, "track.max_leg_distance_m",
          o.max_leg_distance_m, "(0, 2]");
  require(o.thin_circle_score >= 0.0 && o.thin_circle_score <= 1.0, "track.thin_circle_score",
          o.thin_circle_score, "[0, 1]");
  require(o.sure_score >= 0.0 && o.sure_score <= 1.0, "track.sure_score", o.sure_score, "[0, 1]");
  require(o.min_score >= 0.0 && o.min_score <= 1.0, "track.min_score", o.min_score, "[0, 1]");
}

void validate_cylinders(const TrackOptions& o) {
  require(o.min_cylinder_radius_m >= 0.0 && o.min_cylinder_radius_m <= 10.0, "track.min_cylinder_radius_m",
          o.min_cylinder_radius_m, "[0, 10]");
  require(o.max_cylinder_radius_m > o.min_cylinder_radius_m && o.max_cylinder_radius_m <= 100.0,
          "track.max_cylinder_radius_m", o.max_cylinder_radius_m, "(min_cylinder_radius_m, 100]");
  require(o.mobile_distance_m > 0.0 && o.mobile_distance_m <= 10.0, "track.mobile_distance_m",
          o.mobile_distance_m, "(0, 10]");
}

}  // namespace

void TrackOptions::validate() const {
  require_choice(motion, "track.motion", kMotionSourceWords);
  validate_gates(*this);
  validate_evidence(*this);
  validate_cylinders(*this);
}

}  // namespace scanbed
