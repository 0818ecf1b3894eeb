// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/track/assignment.hpp"
#include "core/track/live_track.hpp"
#include "core/track/lost_people.hpp"

namespace scanbed {

/// Follows legs and people. A person has room for two legs, a leg track for one; all legs of a scan are
/// assigned to these places at once. Two leg tracks that keep close become a person, and so does a single one
/// that walks. Who walked and was lost keeps the id when coming back.
class PeopleTracker {
 public:
  void update(const TrackedScan& now, const std::vector<Leg>& legs, const TrackOptions& options);

  std::vector<LiveTrack>& tracks() { return tracks_; }

 private:
  /// Room for one leg in a track.
  struct Slot {
    int track = 0;
  };
  struct Pair {
    double distance_m = 0.0;
    int a = 0, b = 0;
  };

  void make_slots();
  void assign(const std::vector<Leg>& legs, const TrackOptions& options);
  void correct(LiveTrack& track, const TrackedScan& now, const std::vector<Leg>& legs,
               const TrackOptions& options);
  void begin_tracks(const TrackedScan& now, const std::vector<Leg>& legs, const TrackOptions& options);
  void find_pairs(double max_distance_m);
  void join_pairs(const TrackOptions& options);
  void absorb_single_legs();
  bool may_be_known(const LiveTrack& track) const;
  LiveTrack* missing_for(const LiveTrack& newcomer);
  void recall_missing(const TrackOptions& options);
  void bury_dead();

  std::vector<LiveTrack> tracks_;
  LostPeople lost_;
  std::vector<Eigen::Vector2d> p_WL_m_;  ///< this scan's legs in the world
  std::vector<char> leg_taken_;
  std::vector<Slot> slots_;
  std::vector<Pair> pairs_;
  Assignment assignment_;
};

}  // namespace scanbed
