// SPDX-License-Identifier: MIT
#include "core/score/track_scorer.hpp"

#include <algorithm>
#include <set>

namespace scanbed {
namespace {

int place_in(const std::set<std::string>& names, const std::string& name) {
  return static_cast<int>(std::distance(names.begin(), names.find(name)));
}

int place_in(const std::set<int>& ids, int id) {
  return static_cast<int>(std::distance(ids.begin(), ids.find(id)));
}

}  // namespace

void TrackScorer::add(const std::vector<FollowedTruth>& truths, const std::vector<Track>& tracks,
                      double dt_s) {
  Scan scan{.truths = truths};
  std::copy_if(tracks.begin(), tracks.end(), std::back_inserter(scan.tracks),
               [this](const Track& track) { return track.kind == kind_; });
  scan.track_of_truth.assign(truths.size(), kNoTrack);
  scan.is_taken.assign(scan.tracks.size(), 0);
  keep_matches(scan);
  match_rest(scan, true);
  match_rest(scan, false);
  count(scan, dt_s);
  count_identities(scan);
}

void TrackScorer::keep_matches(Scan& scan) const {
  for (std::size_t i = 0; i < scan.truths.size(); ++i) {
    const auto last = last_id_.find(scan.truths[i].id);
    if (last == last_id_.end()) continue;
    for (std::size_t k = 0; k < scan.tracks.size(); ++k) {
      if (scan.is_taken[k] != 0 || scan.tracks[k].id != last->second) continue;
      if ((scan.tracks[k].position_m - scan.truths[i].center_m).norm() > gate_m_) continue;
      scan.track_of_truth[i] = static_cast<int>(k);
      scan.is_taken[k] = 1;
    }
  }
}

void TrackScorer::match_rest(Scan& scan, bool resolvable) const {
  Assignment assignment;
  const int num_truths = static_cast<int>(scan.truths.size());
  const int num_tracks = static_cast<int>(scan.tracks.size());
  // At the gate itself a pair is still one; the assignment wants less than the price of none.
  assignment.reset(num_truths, num_tracks, gate_m_ * (1.0 + 1e-12));
  for (int i = 0; i < num_truths; ++i) {
    const bool takes_part = (scan.truths[i].visibility == Visibility::kResolvable) == resolvable;
    if (!takes_part || scan.track_of_truth[i] != kNoTrack) continue;
    for (int k = 0; k < num_tracks; ++k) {
      if (scan.is_taken[k] != 0) continue;
      assignment.allow(i, k, (scan.tracks[k].position_m - scan.truths[i].center_m).norm());
    }
  }
  const std::span<const int> track_of_truth = assignment.solve();
  for (int i = 0; i < num_truths; ++i) {
    if (track_of_truth[i] == kUnassigned) continue;
    scan.track_of_truth[i] = track_of_truth[i];
    scan.is_taken[track_of_truth[i]] = 1;
  }
}

void TrackScorer::count(const Scan& scan, double dt_s) {
  for (std::size_t i = 0; i < scan.truths.size(); ++i) {
    const FollowedTruth& truth = scan.truths[i];
    if (truth.visibility != Visibility::kHidden) tally_.object_time_s += dt_s;
    if (truth.visibility == Visibility::kResolvable) ++tally_.num_truths;
    if (scan.track_of_truth[i] == kNoTrack) continue;
    count_match(truth, scan.tracks[scan.track_of_truth[i]]);
  }
  tally_.num_false += static_cast<int>(std::count(scan.is_taken.begin(), scan.is_taken.end(), 0));
}

void TrackScorer::count_match(const FollowedTruth& truth, const Track& track) {
  const bool resolvable = truth.visibility == Visibility::kResolvable;
  ++(resolvable ? tally_.num_matches : tally_.num_neither);
  if (resolvable) tally_.sum_error_m += (track.position_m - truth.center_m).norm();
  int& last_id = last_id_[truth.id];
  // What passes before a hidden object is excused by it, and does not take its name.
  if (!resolvable && last_id != kNoId) return;
  if (last_id != kNoId && last_id != track.id) ++tally_.num_switches;
  last_id = track.id;
}

// A track that is excused in this scan is with nobody in it, or it would count above the line alone.
void TrackScorer::count_identities(const Scan& scan) {
  std::vector<char> counts(scan.tracks.size(), 1);
  for (std::size_t i = 0; i < scan.truths.size(); ++i) {
    const bool resolvable = scan.truths[i].visibility == Visibility::kResolvable;
    if (!resolvable && scan.track_of_truth[i] != kNoTrack) counts[scan.track_of_truth[i]] = 0;
  }
  for (std::size_t k = 0; k < scan.tracks.size(); ++k) {
    if (counts[k] == 0) continue;
    ++tally_.num_identity_tracks;
    for (const FollowedTruth& truth : scan.truths) {
      if (truth.visibility != Visibility::kResolvable) continue;
      if ((scan.tracks[k].position_m - truth.center_m).norm() > gate_m_) continue;
      ++num_scans_together_[{truth.id, scan.tracks[k].id}];
    }
  }
}

// One track for each object, for the whole run, so that they are together in as many scans as can be.
int TrackScorer::best_identity_matches() const {
  std::set<std::string> objects;
  std::set<int> ids;
  for (const auto& [pair, count] : num_scans_together_) {
    objects.insert(pair.first);
    ids.insert(pair.second);
  }
  Assignment assignment;
  assignment.reset(static_cast<int>(objects.size()), static_cast<int>(ids.size()), 0.0);
  for (const auto& [pair, count] : num_scans_together_) {
    assignment.allow(place_in(objects, pair.first), place_in(ids, pair.second), -count);
  }
  const std::span<const int> id_of_object = assignment.solve();
  int total = 0;
  for (const auto& [pair, count] : num_scans_together_) {
    if (id_of_object[place_in(objects, pair.first)] == place_in(ids, pair.second)) total += count;
  }
  return total;
}

TrackTally TrackScorer::tally() const {
  TrackTally tally = tally_;
  tally.num_identity_true = best_identity_matches();
  return tally;
}

}  // namespace scanbed
