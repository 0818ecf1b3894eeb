// SPDX-License-Identifier: MIT
#pragma once

#include "core/track/ego_motion.hpp"

namespace scanbed {

/// How features are followed over time.
struct TrackOptions {
  MotionSource motion = MotionSource::kAuto;  ///< where the sensor's own motion is taken from
  double gate_m = 0.15;              ///< a feature farther from where a track is expected is not its own ...
  double gate_speed_m_per_s = 1.8;   ///< ... widened by this, times the time since it was last seen ...
  double max_gate_m = 0.6;           ///< ... up to this; then a person's stride, a hidden cylinder's way
  int num_confirming_hits = 2;       ///< a track is reported from this hit on
  double sure_score = 0.95;          ///< ... but two legs at once with a score of this, from the first on
  int num_coasted_scans = 2;         ///< it is reported through so many scans without a hit
  double max_hidden_s = 3.0;         ///< behind something nearer, it is remembered so long
  double max_lost_s = 10.0;          ///< a person who walked and was lost is known again for so long
  double evidence_keep_ratio = 0.8;  ///< share of the mean log-odds that is kept from hit to hit
  double displacement_window_s = 2.0;      ///< net displacement over this time speaks for a person
  double displacement_step_m = 0.35;       ///< so much of it adds 1 to the log-odds
  double max_displacement_evidence = 3.0;  ///< to which it adds no more than this
  double max_leg_distance_m = 0.6;         ///< between two legs that are taken for a person's
  double thin_circle_score = 0.5;          ///< of a leg that was found as a thin circle alone; 0: it is none
  double min_score = 0.62;                 ///< persons and legs below are followed, but not reported
  double min_cylinder_radius_m = 0.09;     ///< thinner circles are not followed
  double max_cylinder_radius_m = 1.0;      ///< thicker ones neither
  double mobile_distance_m = 0.25;  ///< a cylinder that moved so far within the window is mobile for good
  void validate() const;            ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed
