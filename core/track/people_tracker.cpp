// SPDX-License-Identifier: MIT
#include "core/track/people_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace scanbed {
namespace {

constexpr double kPersonAccel_m2_per_s3 = 1.0;
constexpr double kLegAccel_m2_per_s3 = 6.0;  // a leg stops and swings with every step
constexpr double kBothLegsSigma_m = 0.07;    // of their middle, about the person's
constexpr double kOneLegSigma_m = 0.18;      // of one leg, about the person's middle
constexpr double kLegSigma_m = 0.05;         // of a leg, about itself
constexpr double kStartSpeed_m_per_s = 1.0;  // standard deviation of what is not known yet
constexpr double kMaxSurprise = 12.0;        // of a leg that is still a track's: 3.5 standard deviations
constexpr double kStride_m = 0.35;           // of a leg from the person's middle: widens the gate
constexpr double kMaxStride_m = 0.9;         // between a person's legs
constexpr double kAbsorbLeg_m = 0.55;        // of a single leg from a person that lacks one
constexpr double kAbsorbPerson_m = 0.35;     // of two people with one leg each
constexpr double kOwnLeg_m = 0.75;           // a leg so near to a person with one leg is nobody else's ...
constexpr double kOwnThirdLeg_m = 0.5;       // ... nor is one so near to a person with two
constexpr double kWalkDistance_m = 0.7;      // what moves so far within the window walks
constexpr double kPersonRadius_m = 0.25;
constexpr double kLegRadius_m = 0.10;

// Somebody is there if one of two legs is a leg; what one is says nothing of the other.
double either(double score, double other_score) {
  return 1.0 - (1.0 - score) * (1.0 - other_score);
}

bool is_person(const LiveTrack& track) {
  return track.kind == TrackKind::kPerson;
}

bool is_free_leg(const LiveTrack& track) {
  return !is_person(track) && !track.is_dead && track.feature != kNoFeature;
}

bool lacks_a_leg(const LiveTrack& track) {
  return is_person(track) && !track.is_dead && track.second_feature == kNoFeature;
}

// A track of one leg that is so near to a person who lacks one that it is the person's.
bool belongs_to(const LiveTrack& other, const LiveTrack& person) {
  if (other.is_dead || other.feature == kNoFeature || other.second_feature != kNoFeature) return false;
  if (is_person(other) && other.num_hits > person.num_hits) return false;
  const double reach_m = is_person(other) ? kAbsorbPerson_m : kAbsorbLeg_m;
  return (other.point.p_m - person.point.p_m).norm() <= reach_m;
}

// How surprising a leg is for a track: -2 times the log-likelihood of its place, but for a constant that
// makes it 0 where a person who is exactly known has a leg. What is known less takes fewer legs from others.
double surprise_of_leg(double distance_m2, const LiveTrack& track) {
  const double sigma_m = is_person(track) ? kOneLegSigma_m : kLegSigma_m;
  const double var_m2 = track.point.var_p_m2 + sigma_m * sigma_m;
  return distance_m2 / var_m2 + 2.0 * std::log(var_m2 / (kOneLegSigma_m * kOneLegSigma_m));
}

}  // namespace

void PeopleTracker::update(const TrackedScan& now, const std::vector<Leg>& legs,
                           const TrackOptions& options) {
  p_WL_m_.clear();
  for (const Leg& leg : legs) p_WL_m_.push_back(now.X_WS * leg.middle_m);
  for (LiveTrack& track : tracks_) {
    track.predict(now, is_person(track) ? kPersonAccel_m2_per_s3 : kLegAccel_m2_per_s3);
    if (is_person(track) && track.num_missed > 0) lose_way(track.point, now.dt_s);
  }
  lost_.predict(now, kPersonAccel_m2_per_s3, options);
  assign(legs, options);
  for (LiveTrack& track : tracks_) correct(track, now, legs, options);
  begin_tracks(now, legs, options);
  absorb_single_legs();
  join_pairs(options);
  recall_missing(options);
  bury_dead();
}

void PeopleTracker::make_slots() {
  slots_.clear();
  for (int i = 0; i < static_cast<int>(tracks_.size()); ++i) {
    slots_.push_back({i});
    if (is_person(tracks_[i])) slots_.push_back({i});
  }
}

void PeopleTracker::assign(const std::vector<Leg>& legs, const TrackOptions& options) {
  make_slots();
  const int num_legs = static_cast<int>(legs.size());
  assignment_.reset(num_legs, static_cast<int>(slots_.size()), kMaxSurprise);
  for (int column = 0; column < static_cast<int>(slots_.size()); ++column) {
    const LiveTrack& track = tracks_[slots_[column].track];
    const double stride_m = is_person(track) ? kStride_m : 0.0;
    const double gate_m = track.gate_m(options) + stride_m;
    for (int row = 0; row < num_legs; ++row) {
      const double distance_m2 = (p_WL_m_[row] - track.point.p_m).squaredNorm();
      if (distance_m2 < gate_m * gate_m) assignment_.allow(row, column, surprise_of_leg(distance_m2, track));
    }
  }
  leg_taken_.assign(num_legs, 0);
  const std::span<const int> column_of_leg = assignment_.solve();
  for (int row = 0; row < num_legs; ++row) {
    if (column_of_leg[row] == kUnassigned) continue;
    LiveTrack& track = tracks_[slots_[column_of_leg[row]].track];
    (track.feature == kNoFeature ? track.feature : track.second_feature) = row;
    leg_taken_[row] = 1;
  }
}

void PeopleTracker::correct(LiveTrack& track, const TrackedScan& now, const std::vector<Leg>& legs,
                            const TrackOptions& options) {
  if (track.feature == kNoFeature) {
    track.count_miss(now, is_person(track) ? kPersonRadius_m : kLegRadius_m, options);
    return;
  }
  if (track.second_feature != kNoFeature) {
    const double apart_m = (p_WL_m_[track.feature] - p_WL_m_[track.second_feature]).norm();
    if (apart_m > kMaxStride_m) {  // the nearer one is its own
      const auto off_m2 = [&](int leg) { return (p_WL_m_[leg] - track.point.p_m).squaredNorm(); };
      if (off_m2(track.second_feature) < off_m2(track.feature))
        std::swap(track.feature, track.second_feature);
      leg_taken_[track.second_feature] = 0;
      track.second_feature = kNoFeature;
    }
  }
  double log_odds = log_odds_of(legs[track.feature].score);
  Eigen::Vector2d measured_m = p_WL_m_[track.feature];
  double sigma_m = is_person(track) ? kOneLegSigma_m : kLegSigma_m;
  if (track.second_feature != kNoFeature) {
    log_odds = log_odds_of(either(legs[track.feature].score, legs[track.second_feature].score));
    measured_m = (measured_m + p_WL_m_[track.second_feature]) / 2;
    sigma_m = kBothLegsSigma_m;
  }
  track.point.correct(measured_m, sigma_m);
  track.count_hit(log_odds, now, options);
  if (!is_person(track) && track.history.net_displacement_m() > kWalkDistance_m)
    track.kind = TrackKind::kPerson;
}

void PeopleTracker::begin_tracks(const TrackedScan& now, const std::vector<Leg>& legs,
                                 const TrackOptions& options) {
  for (int i = 0; i < static_cast<int>(legs.size()); ++i) {
    if (leg_taken_[i] != 0) continue;
    LiveTrack track;
    track.point.p_m = p_WL_m_[i];
    track.point.var_p_m2 = kLegSigma_m * kLegSigma_m;
    track.point.var_v_m2_per_s2 = kStartSpeed_m_per_s * kStartSpeed_m_per_s;
    track.feature = i;
    track.count_hit(log_odds_of(legs[i].score), now, options);
    tracks_.push_back(track);
  }
}

// A leg beside a person that lacks one is that one; so is a person of one leg, who began as a leg that
// walked.
void PeopleTracker::absorb_single_legs() {
  for (LiveTrack& person : tracks_) {
    for (LiveTrack& other : tracks_) {
      if (!lacks_a_leg(person)) break;
      if (&other == &person || !belongs_to(other, person)) continue;
      other.is_dead = true;
      (person.feature == kNoFeature ? person.feature : person.second_feature) = other.feature;
    }
  }
}

void PeopleTracker::find_pairs(double max_distance_m) {
  pairs_.clear();
  const int num_tracks = static_cast<int>(tracks_.size());
  for (int a = 0; a < num_tracks; ++a) {
    if (!is_free_leg(tracks_[a])) continue;
    for (int b = a + 1; b < num_tracks; ++b) {
      if (!is_free_leg(tracks_[b])) continue;
      const double distance_m = (tracks_[a].point.p_m - tracks_[b].point.p_m).norm();
      if (distance_m <= max_distance_m) pairs_.push_back({distance_m, a, b});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& left, const Pair& right) {
    return std::tie(left.distance_m, left.a, left.b) < std::tie(right.distance_m, right.a, right.b);
  });
}

void PeopleTracker::join_pairs(const TrackOptions& options) {
  find_pairs(options.max_leg_distance_m);
  for (const Pair& pair : pairs_) {
    LiveTrack& elder = tracks_[pair.a];  // tracks stand in the order of their birth
    LiveTrack& younger = tracks_[pair.b];
    if (!is_free_leg(elder) || !is_free_leg(younger)) continue;
    elder.kind = TrackKind::kPerson;
    elder.second_feature = younger.feature;
    const Eigen::Vector2d to_middle_m = (younger.point.p_m - elder.point.p_m) / 2;
    elder.point.p_m += to_middle_m;
    elder.history.shift(to_middle_m);  // nobody walked there
    elder.point.v_m_per_s = (elder.point.v_m_per_s + younger.point.v_m_per_s) / 2;
    elder.log_odds = std::max(elder.log_odds, younger.log_odds);
    younger.is_dead = true;
  }
}

// A person of no name yet, or a leg that is one more likely than not and is nobody's in sight.
bool PeopleTracker::may_be_known(const LiveTrack& track) const {
  if (track.is_dead || track.feature == kNoFeature) return false;
  if (is_person(track)) return track.id == 0;
  return track.log_odds > 0.0 && std::none_of(tracks_.begin(), tracks_.end(), [&](const LiveTrack& other) {
           if (!is_person(other) || other.is_dead || other.feature == kNoFeature) return false;
           const double own_m = lacks_a_leg(other) ? kOwnLeg_m : kOwnThirdLeg_m;
           return (other.point.p_m - track.point.p_m).norm() < own_m;
         });
}

LiveTrack* PeopleTracker::missing_for(const LiveTrack& newcomer) {
  LiveTrack* likeliest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](LiveTrack& missing) {
    if (missing.is_dead) return;
    const double surprise = surprise_of(newcomer, missing);
    if (surprise >= least) return;
    least = surprise;
    likeliest = &missing;
  };
  for (LiveTrack& lost : lost_.people()) consider(lost);
  for (LiveTrack& track : tracks_) {
    const bool is_known = is_person(track) && track.id != 0 && track.is_mobile;
    if (is_known && track.feature == kNoFeature) consider(track);
  }
  return likeliest;
}

void PeopleTracker::recall_missing(const TrackOptions& options) {
  for (LiveTrack& newcomer : tracks_) {
    if (!may_be_known(newcomer)) continue;
    LiveTrack* const missing = missing_for(newcomer);
    if (missing == nullptr) continue;
    take_over(newcomer, *missing, options);
    missing->id = 0;
    missing->is_dead = true;
  }
  lost_.bury_dead();
}

void PeopleTracker::bury_dead() {
  for (const LiveTrack& track : tracks_) {
    if (track.is_dead) lost_.remember(track);
  }
  std::erase_if(tracks_, [](const LiveTrack& track) { return track.is_dead; });
}

}  // namespace scanbed
