// SPDX-License-Identifier: MIT
#include "core/track/people_step.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/track/gait_expectation.hpp"
#include "core/track/recall_people.hpp"

namespace scanbed {
namespace {

constexpr double kPersonAccel_m2_per_s3 = 1.0;
constexpr double kLegAccel_m2_per_s3 = 6.0;        // a leg stops and swings with every step
constexpr double kLegSigma_m = 0.05;               // of a leg, about itself
constexpr double kPersonStartSpeed_m_per_s = 1.0;  // standard deviation of what is not known yet
constexpr double kMaxSurprise = 12.0;      // of a leg that is still a track's: 3.5 standard deviations
constexpr double kMaxSplitSurprise = 4.0;  // of a leg that may be a part of another one
constexpr double kSplit_m = 0.13;          // between the parts of one leg
constexpr double kAwaySurprise = 2.0;      // of whoever was not seen in the last scan to be seen in this one
constexpr double kWidthSigma_m = 0.02;     // of a leg's width, beside the spacing of beams
constexpr double kNarrowRatio = 3.0;       // by which a leg is rather too narrow than too wide
constexpr double kMaxWidthSurprise = 6.0;
constexpr double kUsualWidthSurprise = 0.7;  // of the own legs
constexpr double kWidthGain = 0.08;          // share of a new width in the mean, at least
constexpr int kMinWidths = 5;                // hits, before which the mean says nothing
constexpr double kStride_m = 0.35;           // of a leg from the person's middle: widens the gate
constexpr double kMaxStride_m = 0.8;         // between a person's legs
constexpr double kAbsorbLeg_m = 0.55;        // of a single leg from a person that lacks one
constexpr double kAbsorbPerson_m = 0.35;     // of two people with one leg each
constexpr double kWalkDistance_m = 0.7;      // what moves so far within the window walks
constexpr double kPersonRadius_m = 0.25;
constexpr double kLegRadius_m = 0.10;
constexpr std::size_t kMaxNearLegs = 12;        // that a person may claim: their pairs are no end otherwise
constexpr std::uint64_t kMaxBirths = 1u << 16;  // of a scan

// Somebody is there if one of two legs is a leg; what one is says nothing of the other.
double either(double score, double other_score) {
  return 1.0 - (1.0 - score) * (1.0 - other_score);
}

bool is_free_leg(const LiveTrack& track) {
  return !track.is_person() && !track.is_dead && track.feature != kNoFeature;
}

// A track of one leg that is so near to a person who lacks one that it is the person's.
bool belongs_to(const LiveTrack& other, const LiveTrack& person) {
  if (other.is_dead || other.feature == kNoFeature || other.second_feature != kNoFeature) return false;
  if (other.is_person() && other.num_hits > person.num_hits) return false;
  const double reach_m = other.is_person() ? kAbsorbPerson_m : kAbsorbLeg_m;
  return (other.point.p_m - person.point.p_m).norm() <= reach_m;
}

// A leg beside a person that lacks one is that one; so is a person of one leg, who began as a leg that
// walked.
void absorb_single_legs(std::vector<LiveTrack>& tracks) {
  for (LiveTrack& person : tracks) {
    for (LiveTrack& other : tracks) {
      if (!person.lacks_a_leg()) break;
      if (&other == &person || !belongs_to(other, person)) continue;
      other.is_dead = true;
      (person.feature == kNoFeature ? person.feature : person.second_feature) = other.feature;
    }
  }
}

// Of a leg for a leg's own track.
double surprise_of_leg(double distance_m2, const LiveTrack& track) {
  return surprise_of_place(distance_m2, track.point.var_p_m2 + kLegSigma_m * kLegSigma_m);
}

void bury_dead(PeopleHypothesis& hypothesis) {
  for (const LiveTrack& track : hypothesis.tracks) {
    if (track.is_dead) hypothesis.lost.remember(track);
  }
  std::erase_if(hypothesis.tracks, [](const LiveTrack& track) { return track.is_dead; });
}

}  // namespace

void PeopleStep::begin(const TrackedScan& now, const std::vector<Leg>& legs, const TrackOptions& options) {
  now_ = &now;
  legs_ = &legs;
  options_ = &options;
  ++num_scans_;
  p_WL_m_.clear();
  for (const Leg& leg : legs) p_WL_m_.push_back(now.X_WS * leg.middle_m);
  measure_widths();
  price_legs();
}

void PeopleStep::measure_widths() {
  widths_.clear();
  for (const Leg& leg : *legs_) {
    const double spacing_m = std::abs(now_->scan.geometry.step_rad) * leg.middle_m.norm();
    widths_.push_back({(leg.beams.last - leg.beams.first + 1) * spacing_m, kWidthSigma_m + spacing_m});
  }
}

// A weak sign of who it is: a child's legs are thin, a skirt is wide. What something nearer hides in part
// looks narrower than it is.
double PeopleStep::surprise_of_width(const LiveTrack& track, int leg) const {
  if (track.num_hits < kMinWidths) return 0.0;
  double off = (widths_[leg].width_m - track.leg_width_m) / widths_[leg].sigma_m;
  if (off < 0.0) off /= kNarrowRatio;
  return std::min(kMaxWidthSurprise, off * off) - kUsualWidthSurprise;
}

// A leg may be split in two, by a fold of clothes: then the less sure part needs nobody to explain it.
void PeopleStep::price_legs() {
  price_.assign(legs_->size(), kMaxSurprise);
  for (std::size_t i = 0; i < legs_->size(); ++i) {
    for (std::size_t k = 0; k < legs_->size(); ++k) {
      const bool is_surer = (*legs_)[k].score > (*legs_)[i].score;
      if (is_surer && (p_WL_m_[i] - p_WL_m_[k]).norm() < kSplit_m) price_[i] = kMaxSplitSurprise;
    }
  }
}

void PeopleStep::predict(PeopleHypothesis& hypothesis) const {
  for (LiveTrack& track : hypothesis.tracks) {
    track.predict(*now_, track.is_person() ? kPersonAccel_m2_per_s3 : kLegAccel_m2_per_s3);
    if (track.is_person() && track.num_missed > 0) lose_way(track.point, now_->dt_s);
  }
  hypothesis.lost.predict(*now_, kPersonAccel_m2_per_s3, *options_);
}

void PeopleStep::claim(const PeopleHypothesis& hypothesis, LegClaims& claims) {
  claims.reset(static_cast<int>(hypothesis.tracks.size()), static_cast<int>(p_WL_m_.size()));
  for (int index = 0; index < static_cast<int>(hypothesis.tracks.size()); ++index) {
    const LiveTrack& track = hypothesis.tracks[index];
    const double gate_m = track.gate_m(*options_) + (track.is_person() ? kStride_m : 0.0);
    near_legs_.clear();
    for (int leg = 0; leg < static_cast<int>(p_WL_m_.size()); ++leg) {
      const double distance_m2 = (p_WL_m_[leg] - track.point.p_m).squaredNorm();
      if (distance_m2 >= gate_m * gate_m) continue;
      near_legs_.push_back(leg);
      if (track.is_person()) continue;
      claims.add({.track = index,
                  .first = leg,
                  .gain = price_[leg] - surprise_of_leg(distance_m2, track) - surprise_of_width(track, leg)});
    }
    if (!track.is_person() || near_legs_.empty()) continue;
    keep_nearest_legs(track);
    claim_for_person(index, track, claims);
  }
}

void PeopleStep::keep_nearest_legs(const LiveTrack& track) {
  if (near_legs_.size() <= kMaxNearLegs) return;
  const auto off_m2 = [&](int leg) { return (p_WL_m_[leg] - track.point.p_m).squaredNorm(); };
  const auto end = near_legs_.begin() + kMaxNearLegs;
  std::partial_sort(near_legs_.begin(), end, near_legs_.end(),
                    [&](int a, int b) { return std::pair(off_m2(a), a) < std::pair(off_m2(b), b); });
  near_legs_.erase(end, near_legs_.end());
}

void PeopleStep::claim_for_person(int index, const LiveTrack& person, LegClaims& claims) {
  const GaitExpectation expectation(person);
  const double away = person.num_missed > 0 ? kAwaySurprise : 0.0;
  for (std::size_t i = 0; i < near_legs_.size(); ++i) {
    const int a = near_legs_[i];
    const Eigen::Vector2d& p_WA_m = p_WL_m_[a];
    const double width_a = surprise_of_width(person, a);
    claims.add(
        {.track = index, .first = a, .gain = price_[a] - expectation.surprise_of(p_WA_m) - away - width_a});
    for (std::size_t k = i + 1; k < near_legs_.size(); ++k) {
      const int b = near_legs_[k];
      const Eigen::Vector2d& p_WB_m = p_WL_m_[b];
      if ((p_WA_m - p_WB_m).squaredNorm() > kMaxStride_m * kMaxStride_m) continue;
      const double surprise =
          expectation.surprise_of(p_WA_m, p_WB_m) + away + width_a + surprise_of_width(person, b);
      claims.add({.track = index, .first = a, .second = b, .gain = price_[a] + price_[b] - surprise});
    }
  }
}

void PeopleStep::explain(PeopleHypothesis& hypothesis, std::span<const LegClaim> claim_of_track) {
  std::vector<LiveTrack>& tracks = hypothesis.tracks;
  leg_taken_.assign(p_WL_m_.size(), 0);
  for (int index = 0; index < static_cast<int>(tracks.size()); ++index) {
    const LegClaim& claim = claim_of_track[index];
    for (const int leg : {claim.first, claim.second}) {
      if (leg != kNoLeg) leg_taken_[leg] = 1;
    }
    tracks[index].feature = claim.first;
    tracks[index].second_feature = claim.second;
    correct(tracks[index]);
  }
  begin_tracks(tracks);
  absorb_single_legs(tracks);
  join_pairs(tracks);
  recall_people(tracks, hypothesis.lost, *options_);
  for (LiveTrack& track : tracks) remember_legs(track);
  bury_dead(hypothesis);
}

void PeopleStep::correct(LiveTrack& track) const {
  if (track.feature == kNoFeature) {
    track.count_miss(*now_, track.is_person() ? kPersonRadius_m : kLegRadius_m, *options_);
    return;
  }
  double log_odds = log_odds_of((*legs_)[track.feature].score);
  Eigen::Vector2d measured_m = p_WL_m_[track.feature];
  double sigma_m = track.is_person() ? kOneLegSigma_m : kLegSigma_m;
  if (track.second_feature != kNoFeature) {
    log_odds = log_odds_of(either((*legs_)[track.feature].score, (*legs_)[track.second_feature].score));
    measured_m = (measured_m + p_WL_m_[track.second_feature]) / 2;
    sigma_m = kBothLegsSigma_m;
  }
  for (const int leg : {track.feature, track.second_feature}) {
    if (leg != kNoFeature)
      track.leg_width_m +=
          std::max(kWidthGain, 1.0 / (track.num_hits + 1.0)) * (widths_[leg].width_m - track.leg_width_m);
  }
  track.point.correct(measured_m, sigma_m);
  track.count_hit(log_odds, *now_, *options_);
  if (!track.is_person() && track.history.net_displacement_m() > kWalkDistance_m)
    track.kind = TrackKind::kPerson;
}

void PeopleStep::begin_tracks(std::vector<LiveTrack>& tracks) const {
  for (int i = 0; i < static_cast<int>(p_WL_m_.size()); ++i) {
    if (leg_taken_[i] != 0) continue;
    LiveTrack track;
    track.birth = num_scans_ * kMaxBirths + static_cast<std::uint64_t>(i);
    track.point.p_m = p_WL_m_[i];
    track.point.var_p_m2 = kLegSigma_m * kLegSigma_m;
    track.point.var_v_m2_per_s2 = kPersonStartSpeed_m_per_s * kPersonStartSpeed_m_per_s;
    track.feature = i;
    track.leg_width_m = widths_[i].width_m;
    track.count_hit(log_odds_of((*legs_)[i].score), *now_, *options_);
    tracks.push_back(track);
  }
}

void PeopleStep::find_pairs(const std::vector<LiveTrack>& tracks) {
  pairs_.clear();
  for (int a = 0; a < static_cast<int>(tracks.size()); ++a) {
    if (!is_free_leg(tracks[a])) continue;
    for (int b = a + 1; b < static_cast<int>(tracks.size()); ++b) {
      if (!is_free_leg(tracks[b])) continue;
      const double distance_m = (tracks[a].point.p_m - tracks[b].point.p_m).norm();
      if (distance_m <= options_->max_leg_distance_m) pairs_.push_back({distance_m, a, b});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& left, const Pair& right) {
    return std::tie(left.distance_m, left.a, left.b) < std::tie(right.distance_m, right.a, right.b);
  });
}

void PeopleStep::join_pairs(std::vector<LiveTrack>& tracks) {
  find_pairs(tracks);
  for (const Pair& pair : pairs_) {
    LiveTrack& elder = tracks[pair.a];
    LiveTrack& younger = tracks[pair.b];
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

void PeopleStep::remember_legs(LiveTrack& track) const {
  track.recent_legs = with_legs(track.recent_legs, track.feature, track.second_feature);
  if (track.feature == kNoFeature) return;
  track.num_legs_seen = 0;
  for (const int leg : {track.feature, track.second_feature}) {
    if (leg != kNoFeature) track.p_WL_m[track.num_legs_seen++] = p_WL_m_[leg];
  }
}

}  // namespace scanbed
