// SPDX-License-Identifier: MIT
#include "core/track/recall_people.hpp"

#include <algorithm>
#include <limits>

namespace scanbed {
namespace {

constexpr double kOwnLeg_m = 0.75;      // a leg so near to a person with one leg is nobody else's ...
constexpr double kOwnThirdLeg_m = 0.5;  // ... nor is one so near to a person with two

bool owns(const LiveTrack& person, const LiveTrack& leg) {
  if (!person.is_person() || person.is_dead || person.feature == kNoFeature) return false;
  const double own_m = person.lacks_a_leg() ? kOwnLeg_m : kOwnThirdLeg_m;
  return (person.point.p_m - leg.point.p_m).norm() < own_m;
}

// A person of no name yet, or a leg that is one more likely than not and is nobody's in sight.
bool may_be_known(const LiveTrack& track, const std::vector<LiveTrack>& tracks) {
  if (track.is_dead || track.feature == kNoFeature) return false;
  if (track.is_person()) return track.id == 0;
  return track.log_odds > 0.0 && std::none_of(tracks.begin(), tracks.end(),
                                              [&](const LiveTrack& other) { return owns(other, track); });
}

LiveTrack* missing_for(const LiveTrack& newcomer, std::vector<LiveTrack>& tracks, LostPeople& lost) {
  LiveTrack* likeliest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](LiveTrack& missing) {
    if (missing.is_dead) return;
    const double surprise = surprise_of(newcomer, missing);
    if (surprise >= least) return;
    least = surprise;
    likeliest = &missing;
  };
  for (LiveTrack& person : lost.people()) consider(person);
  for (LiveTrack& track : tracks) {
    const bool is_known = track.is_person() && track.id != 0 && track.is_mobile;
    if (is_known && track.feature == kNoFeature) consider(track);
  }
  return likeliest;
}

}  // namespace

void recall_people(std::vector<LiveTrack>& tracks, LostPeople& lost, const TrackOptions& options) {
  for (LiveTrack& newcomer : tracks) {
    if (!may_be_known(newcomer, tracks)) continue;
    LiveTrack* const missing = missing_for(newcomer, tracks, lost);
    if (missing == nullptr) continue;
    take_over(newcomer, *missing, options);
    missing->id = 0;
    missing->is_dead = true;
  }
  lost.bury_dead();
}

}  // namespace scanbed
