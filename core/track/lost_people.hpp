// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/track/live_track.hpp"

namespace scanbed {

/// How surprising it would be if a newcomer were somebody who is not seen any more: -2 times the
/// log-likelihood of its place, but for a constant. Infinite where it cannot be: it came before the other one
/// went, or is farther off than who hurries gets.
double surprise_of(const LiveTrack& newcomer, const LiveTrack& missing);

/// Makes a newcomer somebody who was missing, with id and evidence, as if nobody had ever been lost.
void take_over(LiveTrack& newcomer, const LiveTrack& missing, const TrackOptions& options);

/// Takes from a velocity what dt out of sight leaves no longer certain: who went there may have turned.
void lose_way(MovingPoint& point, double dt_s);

/// People who walked, were reported and are lost, until they come back or are forgotten. They are expected
/// ever less far ahead, and ever less exactly.
class LostPeople {
 public:
  /// Remembers a track as it is, where it is of a person that walked and was reported.
  void remember(const LiveTrack& track);

  /// Moves all on to the scan's time; forgets whom nobody has seen for max_lost_s.
  void predict(const TrackedScan& now, double accel_psd_m2_per_s3, const TrackOptions& options);

  std::vector<LiveTrack>& people() { return people_; }
  const std::vector<LiveTrack>& people() const { return people_; }

  /// Forgets those that are marked as dead.
  void bury_dead();

 private:
  std::vector<LiveTrack> people_;
};

}  // namespace scanbed
