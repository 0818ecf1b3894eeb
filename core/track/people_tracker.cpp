// SPDX-License-Identifier: MIT
#include "core/track/people_tracker.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace scanbed {
namespace {

constexpr int kMaxHypotheses = 12;
constexpr int kMaxAnswers = 6;           // of one hypothesis to one scan
constexpr double kMaxLoss = 8.0;         // what costs so much more than the best is dropped
constexpr double kChangeSurprise = 1.0;  // of somebody shown being taken for somebody else
constexpr double kSamePlace_m = 0.5;     // who is so near to where somebody was shown is that one
constexpr double kOwnPlace_m = 0.1;      // by so much each is nearer to the own place

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of splitmix64
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

PeopleTracker::PeopleTracker() {
  hypotheses_.store.resize(kMaxHypotheses);
  grown_.store.resize(kMaxHypotheses);
  hypotheses_.size = 1;
}

void PeopleTracker::update(const TrackedScan& now, const std::vector<Leg>& legs,
                           const TrackOptions& options) {
  step_.begin(now, legs, options);
  branch();
  grow_children();
  std::swap(hypotheses_, grown_);
  level_storage();
  choose_shown(now.dt_s, options);
  remember_shown(options);
}

void PeopleTracker::branch() {
  children_.clear();
  claim_of_track_.clear();
  for (int parent = 0; parent < hypotheses_.size; ++parent) {
    PeopleHypothesis& hypothesis = hypotheses_.store[parent];
    step_.predict(hypothesis);
    step_.claim(hypothesis, claims_);
    for (const LegClaims::Answer& answer : claims_.solve(kMaxAnswers, kMaxLoss)) {
      Child child{
          .cost = hypothesis.cost - answer.gain, .parent = parent, .first_claim = claim_of_track_.size()};
      for (int track = 0; track < static_cast<int>(hypothesis.tracks.size()); ++track)
        claim_of_track_.push_back(claims_.claim_of(answer, track));
      child.key = key_of(child);
      children_.push_back(child);
    }
  }
  std::sort(children_.begin(), children_.end(), [](const Child& a, const Child& b) {
    return std::tie(a.cost, a.first_claim) < std::tie(b.cost, b.first_claim);
  });
}

std::uint64_t PeopleTracker::key_of(const Child& child) const {
  const std::vector<LiveTrack>& tracks = hypotheses_.store[child.parent].tracks;
  std::uint64_t key = tracks.size();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const LegClaim& claim = claim_of_track_[child.first_claim + i];
    key = mixed(mixed(key + tracks[i].birth) + with_legs(tracks[i].recent_legs, claim.first, claim.second));
  }
  return key;
}

// The likeliest children, but for those that agree with a likelier one.
void PeopleTracker::grow_children() {
  const double least_cost = children_.front().cost;
  grown_.size = 0;
  for (auto child = children_.begin(); child != children_.end(); ++child) {
    if (grown_.size == kMaxHypotheses || child->cost > least_cost + kMaxLoss) break;
    const auto agrees = [&](const Child& other) { return other.key == child->key; };
    if (std::any_of(children_.begin(), child, agrees)) continue;
    PeopleHypothesis& grown = grown_.store[grown_.size++];
    grown = hypotheses_.store[child->parent];
    grown.cost = child->cost - least_cost;
    step_.explain(grown, std::span(claim_of_track_).subspan(child->first_claim, grown.tracks.size()));
  }
}

// Hypotheses take each other's places: what one of them needs, all will.
void PeopleTracker::level_storage() {
  std::size_t most_tracks = 0;
  std::size_t most_lost = 0;
  for (const Pool* pool : {&hypotheses_, &grown_}) {
    for (const PeopleHypothesis& hypothesis : pool->store) {
      most_tracks = std::max(most_tracks, hypothesis.tracks.capacity());
      most_lost = std::max(most_lost, hypothesis.lost.people().capacity());
    }
  }
  for (Pool* pool : {&hypotheses_, &grown_}) {
    for (PeopleHypothesis& hypothesis : pool->store) {
      hypothesis.tracks.reserve(most_tracks);
      hypothesis.lost.people().reserve(most_lost);
    }
  }
}

// How many people would be somebody else than was shown in their places in the last scan.
int PeopleTracker::num_changes(const PeopleHypothesis& hypothesis, double dt_s,
                               const TrackOptions& options) const {
  int num_changes = 0;
  for (const LiveTrack& track : hypothesis.tracks) {
    if (!track.is_person() || !track.is_shown(options)) continue;
    double nearest_m = kSamePlace_m;
    std::uint64_t birth = track.birth;
    for (const Shown& shown : shown_people_) {
      double distance_m = (shown.p_m + dt_s * shown.v_m_per_s - track.point.p_m).norm();
      if (shown.birth == track.birth) distance_m -= kOwnPlace_m;
      if (distance_m >= nearest_m) continue;
      nearest_m = distance_m;
      birth = shown.birth;
    }
    if (birth != track.birth) ++num_changes;
  }
  return num_changes;
}

void PeopleTracker::choose_shown(double dt_s, const TrackOptions& options) {
  double least_cost = std::numeric_limits<double>::infinity();
  for (int i = 0; i < hypotheses_.size; ++i) {
    const PeopleHypothesis& hypothesis = hypotheses_.store[i];
    const double cost = hypothesis.cost + kChangeSurprise * num_changes(hypothesis, dt_s, options);
    if (cost >= least_cost) continue;
    least_cost = cost;
    shown_ = i;
  }
}

void PeopleTracker::remember_shown(const TrackOptions& options) {
  shown_people_.clear();
  for (const LiveTrack& track : tracks()) {
    if (track.is_person() && track.is_shown(options))
      shown_people_.push_back({track.birth, track.point.p_m, track.point.v_m_per_s});
  }
}

void PeopleTracker::spread_ids() {
  for (const LiveTrack& shown : tracks()) {
    if (shown.id == 0) continue;
    for (PeopleHypothesis& hypothesis : hypotheses_.all()) {
      for (LiveTrack& track : hypothesis.tracks) {
        if (track.birth == shown.birth) track.id = shown.id;
      }
    }
  }
}

}  // namespace scanbed
