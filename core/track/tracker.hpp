// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/track/cylinder_tracker.hpp"
#include "core/track/ego_motion.hpp"
#include "core/track/people_tracker.hpp"
#include "core/track/track.hpp"
#include "core/track/track_options.hpp"

namespace scanbed {

/// Follows people, legs and cylinders from scan to scan while the sensor moves: constant-velocity Kalman
/// filters in a world frame; circles are assigned one-to-one within gates, legs as PeopleTracker says. Keeps
/// its buffers, so that it allocates nothing once it has seen as much at a time as it will.
class Tracker {
 public:
  /// @throws InputError where the options do not validate.
  explicit Tracker(const TrackOptions& options = {});

  const TrackOptions& options() const { return options_; }

  /// Takes effect from the next scan on; tracks live on. @throws InputError where the options do not
  /// validate.
  void set_options(const TrackOptions& options);

  /// Takes the next scan and its features.
  ///
  /// @returns the confirmed tracks, in rising order of id; valid until the next call.
  const std::vector<Track>& update(const LaserScan& scan, const Features& features);

  /// The same where the sensor's pose in a world frame is known otherwise.
  const std::vector<Track>& update(const LaserScan& scan, const Features& features, const Pose2& X_WS);

  const std::vector<Track>& tracks() const { return reported_; }

  /// X_WS: the sensor in the world frame of the tracks, at the latest scan.
  const Pose2& pose() const { return X_WS_; }

 private:
  double step_s(double time_s);
  void mark_legs(const Features& features);
  void gather_legs(const Features& features);
  void hide_unreported(int num_legs);
  void report(std::vector<LiveTrack>& tracks);

  TrackOptions options_;
  EgoMotion ego_motion_;
  PeopleTracker people_;
  CylinderTracker cylinders_;
  Pose2 X_WS_;
  bool has_begun_ = false;
  double last_time_s_ = 0.0;
  int last_id_ = 0;
  std::vector<Leg> legs_;  ///< of this scan: those reported, those in doubt, then thin circles
  std::vector<char> circle_is_leg_;
  std::vector<Track> reported_;
};

}  // namespace scanbed
