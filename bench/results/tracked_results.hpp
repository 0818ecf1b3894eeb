// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "bench/results/labels.hpp"
#include "core/detect/detector_options.hpp"
#include "core/detect/leg/leg_forest.hpp"
#include "core/track/track_options.hpp"

namespace scanbed::bench {

/// What is followed, and how.
struct TrackedSetup {
  DetectorOptions detector;
  TrackOptions tracker;
};

struct TrackedLegResult {
  int num_scans = 0;
  int num_labels = 0;
  int num_found = 0;   ///< labels with a leg track within 0.15 m or a person track within 0.40 m
  int num_tracks = 0;  ///< confirmed tracks of people and legs, summed over the scans
  std::vector<int> num_tracks_of_scan;
};

/// Follows legs and people through a recording. A leg track finds one labelled leg, a person track two,
/// nearest first; in a recording without people every such track is false.
TrackedLegResult tracked_legs_in_recording(const std::filesystem::path& log, const Labels& labels,
                                           const TrackedSetup& setup,
                                           const LegForest& forest = trained_leg_forest());

}  // namespace scanbed::bench
