// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/track/live_track.hpp"
#include "core/track/lost_people.hpp"

namespace scanbed {

/// Makes newcomers those who walked and are missing, each the one that is most likely there: one of the
/// tracks that this scan does not show, or one that is lost. Newcomers are people of no name yet, and legs
/// that are nobody's in sight.
void recall_people(std::vector<LiveTrack>& tracks, LostPeople& lost, const TrackOptions& options);

}  // namespace scanbed
