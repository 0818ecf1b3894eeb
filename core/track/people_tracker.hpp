// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/track/people_step.hpp"

namespace scanbed {

/// Follows legs and people: all legs of a scan are assigned at once to all who may have them. Whose a leg is
/// may show only scans later; so a few hypotheses are kept, of which each takes on the scan in the few ways
/// that are likeliest. What is shown is the likeliest, unless it differs from what was shown before in whom
/// it takes people for, and is but a little likelier.
///
/// @par Source  Reid, "An algorithm for tracking multiple targets", IEEE Transactions on Automatic Control,
///              1979; hypotheses that agree on the last scans are merged, as in section IV there.
class PeopleTracker {
 public:
  PeopleTracker();

  void update(const TrackedScan& now, const std::vector<Leg>& legs, const TrackOptions& options);

  /// Of the hypothesis that is shown.
  std::vector<LiveTrack>& tracks() { return hypotheses_.store[shown_].tracks; }

  /// Gives the ids of the shown tracks to the same tracks in all other hypotheses.
  void spread_ids();

 private:
  /// A hypothesis of this scan, as what makes it: one of the last scan and whose the legs are.
  struct Child {
    double cost = 0.0;
    int parent = 0;
    std::uint64_t key = 0;  ///< equal where children agree on all tracks, and on their legs in three scans
    std::size_t first_claim = 0;
  };
  struct Shown {
    std::uint64_t birth = 0;
    Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d v_m_per_s = Eigen::Vector2d::Zero();
  };
  /// Hypotheses that keep their storage when there are fewer of them.
  struct Pool {
    std::vector<PeopleHypothesis> store;
    int size = 0;

    std::span<PeopleHypothesis> all() { return std::span(store).first(size); }
  };

  void branch();
  std::uint64_t key_of(const Child& child) const;
  void grow_children();
  void level_storage();
  int num_changes(const PeopleHypothesis& hypothesis, double dt_s, const TrackOptions& options) const;
  void choose_shown(double dt_s, const TrackOptions& options);
  void remember_shown(const TrackOptions& options);

  PeopleStep step_;
  LegClaims claims_;
  Pool hypotheses_, grown_;
  std::vector<Child> children_;
  std::vector<LegClaim> claim_of_track_;  ///< of each child in turn
  std::vector<Shown> shown_people_;
  int shown_ = 0;
};

}  // namespace scanbed
