// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "bench/results/score_bins.hpp"

namespace scanbed::bench {

/// A point on the curve of recall over false alarms.
struct LegRate {
  double false_a_scan = 0.0;  ///< in nobody.log, within 5 m
  double recall = 0.0;        ///< of labelled legs with 3 points or more
};

/// Figures of the forest on one recording of people, by forests that were trained without it.
struct HeldOutLegs {
  std::vector<LegRate> single_scan;  ///< at 0.3, 0.5, 1 and 2 false legs a scan
  LegRate at_default;                ///< at the preset's least score
  std::vector<LegRate> tracked;      ///< one for each of the least track scores asked for
  ScoreBins scores;                  ///< of the recording's legs, and of false ones in one part of nobody.log
  int num_empty_scans = 0;           ///< in nobody.log
};

/// Trains forests for legs_pos1 and legs_pos2, none of which saw the recording that it is asked about, and
/// measures them. nobody.log is cut into stretches of time; false legs in each are counted by forests that
/// did not see it, and recall is the mean over these forests at one threshold for all.
///
/// @param track_scores  least scores of reported tracks to try.
/// @returns of legs_pos1, then legs_pos2.
std::vector<HeldOutLegs> held_out_legs(const std::filesystem::path& data,
                                       const std::vector<double>& track_scores);

}  // namespace scanbed::bench
