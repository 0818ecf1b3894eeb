// SPDX-License-Identifier: MIT
#include "core/track/leg_claims.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace scanbed {

LegClaims::Answer& LegClaims::Answers::add(int num_tracks) {
  if (size == static_cast<int>(store.size())) store.emplace_back();
  Answer& answer = store[size++];
  answer.gain = 0.0;
  answer.claim.assign(num_tracks, kNoClaim);
  return answer;
}

void LegClaims::reset(int num_tracks, int num_legs) {
  num_tracks_ = num_tracks;
  claims_.clear();
  is_taken_.assign(num_legs, 0);
  claimant_.assign(num_legs, -1);
}

void LegClaims::add(const LegClaim& claim) {
  if (claim.gain > 0.0) claims_.push_back(claim);
}

LegClaim LegClaims::claim_of(const Answer& answer, int track) const {
  return answer.claim[track] == kNoClaim ? LegClaim{.track = track} : claims_[answer.claim[track]];
}

std::span<const LegClaims::Answer> LegClaims::solve(int max_answers, double max_loss) {
  max_answers_ = max_answers;
  max_loss_ = max_loss;
  sort_claims();
  group_tracks();
  pick_.assign(num_tracks_, kNoClaim);
  of_all_.size = 0;
  of_all_.add(num_tracks_);
  for (std::size_t begin = 0; begin < order_.size();) {
    std::size_t end = begin + 1;
    while (end < order_.size() && group_of(order_[end]) == group_of(order_[begin])) ++end;
    const std::span<const int> tracks = std::span(order_).subspan(begin, end - begin);
    solve_group(tracks);
    join_group(tracks);
    begin = end;
  }
  return of_all_.all();
}

void LegClaims::sort_claims() {
  std::sort(claims_.begin(), claims_.end(), [](const LegClaim& a, const LegClaim& b) {
    return std::tuple(a.track, -a.gain, a.first, a.second) < std::tuple(b.track, -b.gain, b.first, b.second);
  });
  range_.assign(num_tracks_, {});
  for (int i = 0; i < static_cast<int>(claims_.size()); ++i) {
    Range& range = range_[claims_[i].track];
    if (range.end == 0) range.begin = i;
    range.end = i + 1;
  }
}

int LegClaims::group_of(int track) {
  while (parent_[track] != track) track = parent_[track] = parent_[parent_[track]];
  return track;
}

// Tracks that claim the same leg are of one group.
void LegClaims::group_tracks() {
  parent_.resize(num_tracks_);
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const LegClaim& claim : claims_) {
    for (const int leg : {claim.first, claim.second}) {
      if (leg == kNoLeg) continue;
      if (claimant_[leg] < 0) claimant_[leg] = claim.track;
      parent_[group_of(claim.track)] = group_of(claimant_[leg]);
    }
  }
  order_.clear();
  for (int track = 0; track < num_tracks_; ++track) {
    if (range_[track].end > range_[track].begin) order_.push_back(track);
  }
  std::sort(order_.begin(), order_.end(),
            [this](int a, int b) { return std::pair(group_of(a), a) < std::pair(group_of(b), b); });
}

void LegClaims::solve_group(std::span<const int> tracks) {
  bound_.assign(tracks.size() + 1, 0.0);
  for (std::size_t i = tracks.size(); i-- > 0;)
    bound_[i] = bound_[i + 1] + claims_[range_[tracks[i]].begin].gain;
  of_group_.size = 0;
  least_gain_ = -std::numeric_limits<double>::infinity();
  num_nodes_ = 0;
  branch(tracks, 0, 0.0);
}

void LegClaims::branch(std::span<const int> tracks, std::size_t depth, double gain) {
  if (depth == tracks.size()) {
    keep_answer(gain);
    return;
  }
  const int track = tracks[depth];
  for (int i = range_[track].begin; i < range_[track].end; ++i) {
    if (gain + claims_[i].gain + bound_[depth + 1] <= least_gain_) return;  // what follows gains less
    if (!is_free(claims_[i])) continue;
    if (of_group_.size > 0 && ++num_nodes_ > kMaxNodes) return;
    pick_[track] = i;
    mark(claims_[i], 1);
    branch(tracks, depth + 1, gain + claims_[i].gain);
    mark(claims_[i], 0);
    pick_[track] = kNoClaim;
  }
  if (gain + bound_[depth + 1] > least_gain_) branch(tracks, depth + 1, gain);
}

void LegClaims::keep_answer(double gain) {
  if (gain <= least_gain_) return;
  std::vector<Answer>& store = of_group_.store;
  if (of_group_.size == max_answers_) --of_group_.size;
  Answer& answer = of_group_.add(num_tracks_);
  answer.gain = gain;
  answer.claim = pick_;
  for (int i = of_group_.size - 1; i > 0 && store[i - 1].gain < store[i].gain; --i)
    std::swap(store[i - 1], store[i]);
  least_gain_ = store[0].gain - max_loss_;
  if (of_group_.size == max_answers_) least_gain_ = std::max(least_gain_, store[max_answers_ - 1].gain);
}

// Groups have nothing to do with each other: the best answers of all are sums of the best of each.
void LegClaims::join_group(std::span<const int> tracks) {
  sums_.clear();
  const double least_gain = of_all_.store[0].gain + of_group_.store[0].gain - max_loss_;
  for (int first = 0; first < of_all_.size; ++first) {
    for (int second = 0; second < of_group_.size; ++second) {
      const double gain = of_all_.store[first].gain + of_group_.store[second].gain;
      if (gain >= least_gain) sums_.push_back({gain, first, second});
    }
  }
  std::sort(sums_.begin(), sums_.end(), [](const Sum& a, const Sum& b) {
    return std::tuple(-a.gain, a.first, a.second) < std::tuple(-b.gain, b.first, b.second);
  });
  joined_.size = 0;
  for (const Sum& sum : sums_) {
    if (joined_.size == max_answers_) break;
    Answer& answer = joined_.add(num_tracks_);
    answer.gain = sum.gain;
    answer.claim = of_all_.store[sum.first].claim;
    for (const int track : tracks) answer.claim[track] = of_group_.store[sum.second].claim[track];
  }
  std::swap(of_all_, joined_);
}

bool LegClaims::is_free(const LegClaim& claim) const {
  return is_taken_[claim.first] == 0 && (claim.second == kNoLeg || is_taken_[claim.second] == 0);
}

void LegClaims::mark(const LegClaim& claim, char taken) {
  is_taken_[claim.first] = taken;
  if (claim.second != kNoLeg) is_taken_[claim.second] = taken;
}

}  // namespace scanbed
