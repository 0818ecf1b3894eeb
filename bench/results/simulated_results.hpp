// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "bench/results/bootstrap.hpp"
#include "bench/results/result_worlds.hpp"
#include "bench/results/score_bins.hpp"
#include "core/detect/detector_options.hpp"

namespace scanbed::bench {

/// Which scans of a set of worlds, and how noisy.
struct SimulatedSet {
  WorldSet worlds = WorldSet::kRooms;
  double sigma_m = 0.005;
  int first_seed = 1;
  int num_runs = 200;  ///< one world each
  int scans_a_run = 3;
};

/// Of each run: what was right of what was reported, and what was found of what was there.
struct KindRuns {
  std::vector<Share> precision;
  std::vector<Share> recall;
};

struct SimulatedResult {
  int num_scans = 0;
  KindRuns circle;
  KindRuns line;
  KindRuns leg;
  ScoreBins leg_scores;
  int num_false_circles = 0;
  int num_false_legs = 0;
  std::vector<double> center_errors_m;  ///< of the circles that are right
};

/// Runs a detector over simulated scans with all of the laser's effects but its systematic range errors:
/// noise, mixed pixels, lost echoes.
///
/// Counted as core/score does, with one exception: in kCut a column counts as truth where others hide it to
/// leave 40 to 90 % of its front and at least 8 beams, and what is hidden more or less is neither hit nor
/// miss.
SimulatedResult simulated_results(const SimulatedSet& set, const DetectorOptions& options);

}  // namespace scanbed::bench
