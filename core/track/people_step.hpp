// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/detect/features.hpp"
#include "core/track/leg_claims.hpp"
#include "core/track/live_track.hpp"
#include "core/track/lost_people.hpp"

namespace scanbed {

/// One account of who is where: of all that legs may mean, one choice for each scan so far.
struct PeopleHypothesis {
  std::vector<LiveTrack> tracks;  ///< in the order of their birth
  LostPeople lost;
  double cost = 0.0;  ///< -2 times the log-likelihood, but for a constant that all of them share
};

/// What one scan does to hypotheses. A person has room for two legs, a leg track for one. Two leg tracks that
/// keep close become a person, and so does a single one that walks. Who walked and was lost keeps the id when
/// coming back.
class PeopleStep {
 public:
  /// Takes the next scan, which is to outlive the calls of the others.
  void begin(const TrackedScan& now, const std::vector<Leg>& legs, const TrackOptions& options);

  /// Moves a hypothesis on to the scan's time.
  void predict(PeopleHypothesis& hypothesis) const;

  /// Tells in what ways its tracks may explain the scan's legs.
  void claim(const PeopleHypothesis& hypothesis, LegClaims& claims);

  /// Gives each of its tracks the legs of its claim, and lets tracks begin, join and end.
  void explain(PeopleHypothesis& hypothesis, std::span<const LegClaim> claim_of_track);

 private:
  struct Width {
    double width_m = 0.0;
    double sigma_m = 0.0;
  };
  struct Pair {
    double distance_m = 0.0;
    int a = 0, b = 0;
  };

  void measure_widths();
  void price_legs();
  double surprise_of_width(const LiveTrack& track, int leg) const;
  void keep_nearest_legs(const LiveTrack& track);
  void claim_for_person(int index, const LiveTrack& person, LegClaims& claims);
  void correct(LiveTrack& track) const;
  void begin_tracks(std::vector<LiveTrack>& tracks) const;
  void find_pairs(const std::vector<LiveTrack>& tracks);
  void join_pairs(std::vector<LiveTrack>& tracks);
  void remember_legs(LiveTrack& track) const;

  const TrackedScan* now_ = nullptr;
  const std::vector<Leg>* legs_ = nullptr;
  const TrackOptions* options_ = nullptr;
  std::uint64_t num_scans_ = 0;
  std::vector<Eigen::Vector2d> p_WL_m_;  ///< the scan's legs in the world
  std::vector<double> price_;            ///< of leaving each of them unexplained
  std::vector<Width> widths_;            ///< of the legs
  std::vector<char> leg_taken_;
  std::vector<int> near_legs_;
  std::vector<Pair> pairs_;
};

}  // namespace scanbed
