// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/score/followed_truth.hpp"
#include "core/score/track_tally.hpp"
#include "core/track/assignment.hpp"
#include "core/track/track.hpp"

namespace scanbed {

/// Compares the tracks of one kind with what they should follow, scan after scan of one run.
///
/// An object keeps the track that it had while that stays within the gate; the others are matched at the
/// least total distance, resolvable objects first. Marginal and hidden objects need no track, and excuse one.
class TrackScorer {
 public:
  /// @param gate_m  > 0, between a track and its object.
  TrackScorer(TrackKind kind, double gate_m) : kind_(kind), gate_m_(gate_m) {}

  /// @param dt_s  since the scan before; 0 for the first.
  void add(const std::vector<FollowedTruth>& truths, const std::vector<Track>& tracks, double dt_s);

  /// Of all scans so far.
  TrackTally tally() const;

 private:
  static constexpr int kNoTrack = -1;
  static constexpr int kNoId = 0;  ///< tracks count from 1

  struct Scan {
    const std::vector<FollowedTruth>& truths;
    std::vector<Track> tracks;        ///< of the kind
    std::vector<int> track_of_truth;  ///< index into tracks
    std::vector<char> is_taken;       ///< of each track
  };

  void keep_matches(Scan& scan) const;
  void match_rest(Scan& scan, bool resolvable) const;
  void count(const Scan& scan, double dt_s);
  void count_match(const FollowedTruth& truth, const Track& track);
  void count_identities(const Scan& scan);
  int best_identity_matches() const;

  TrackKind kind_;
  double gate_m_;
  TrackTally tally_;
  std::map<std::string, int> last_id_;                             ///< of the track that each object had last
  std::map<std::pair<std::string, int>, int> num_scans_together_;  ///< of object and track within the gate
};

}  // namespace scanbed
