// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "core/track/moving_point.hpp"
#include "core/track/place_history.hpp"
#include "core/track/scan_view.hpp"
#include "core/track/track.hpp"
#include "core/track/track_options.hpp"

namespace scanbed {

/// The scan that tracks are brought up to.
struct TrackedScan {
  const LaserScan& scan;
  Pose2 X_WS;
  double dt_s = 0.0;  ///< since the scan before, >= 0
};

/// A track with its memory; world frame W.
struct LiveTrack {
  int id = 0;               ///< 0 until it is shown
  std::uint64_t birth = 0;  ///< tells tracks apart that have no id; the same in all hypotheses
  TrackKind kind = TrackKind::kLeg;
  MovingPoint point;
  PlaceHistory history;
  int num_hits = 0;
  int num_missed = 0;            ///< scans in a row
  double age_s = 0.0;            ///< since the first hit
  double unseen_s = 0.0;         ///< since the last hit
  double hidden_s = 0.0;         ///< of these: while something nearer hid it
  double occupied_s = 0.0;       ///< while something stood there that was not recognised
  double empty_s = 0.0;          ///< the rest
  double log_odds = 0.0;         ///< mean along the track
  double motion_evidence = 0.0;  ///< log-odds that its having moved adds
  double radius_m = 0.0;         ///< of a cylinder
  int feature = kNoFeature;
  int second_feature = kNoFeature;
  std::array<Eigen::Vector2d, 2> p_WL_m{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  ///< its legs, ...
  int num_legs_seen = 0;                  ///< ... as many as there were when it was last seen
  double leg_width_m = 0.0;               ///< mean over its legs, as wide as scans show them
  std::uint64_t recent_legs = 0;          ///< which features it had in the last three scans
  PlaceView view = PlaceView::kOccupied;  ///< of its place, at the latest miss
  bool is_mobile = false;
  bool is_dead = false;

  bool is_person() const { return kind == TrackKind::kPerson; }

  /// A person of whom this scan shows one leg, or none.
  bool lacks_a_leg() const { return is_person() && !is_dead && second_feature == kNoFeature; }

  /// Seen often enough, or as two legs that leave no doubt.
  bool is_confirmed(const TrackOptions& options) const;

  /// Its own gate: how far from where it is expected a feature may be.
  double gate_m(const TrackOptions& options) const;

  /// Moves on to the scan's time, in which what was seen of its motion fades; nothing is seen so far.
  void predict(const TrackedScan& now, double accel_psd_m2_per_s3);

  /// Takes in what a hit says: log-odds of the feature, and where the track is by now.
  void count_hit(double feature_log_odds, const TrackedScan& now, const TrackOptions& options);

  /// Counts a scan without a hit, and marks the track as dead where it has been away too long.
  ///
  /// @param size_m  radius of what is looked for.
  void count_miss(const TrackedScan& now, double size_m, const TrackOptions& options);

  /// It was seen in this scan, or is most likely still where it is expected: not for long, and neither where
  /// beams pass nor where so much time has made its place too doubtful to tell.
  bool is_at_hand(const TrackOptions& options) const;

  /// What is reported: confirmed, at hand, and likely enough where the options ask for that.
  bool is_shown(const TrackOptions& options) const;

  /// It has been watched for a while and stood still.
  bool is_settled() const;

  /// From mean log-odds and motion.
  double evidence() const;
  double score() const;

 private:
  PlaceView view_of_place(const TrackedScan& now, double size_m) const;
};

/// Log-odds of a score in [0, 1], bounded to +-4.
double log_odds_of(double score);

/// `recent_legs` after one scan more, in which a track has these features.
std::uint64_t with_legs(std::uint64_t recent_legs, int feature, int second_feature);

/// How the track looks from outside, in the sensor frame.
Track seen_from(const Pose2& X_WS, const LiveTrack& track);

}  // namespace scanbed
