// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "bench/results/labels.hpp"
#include "bench/results/score_bins.hpp"
#include "core/detect/detector_options.hpp"
#include "core/detect/leg/leg_forest.hpp"

namespace scanbed::bench {

struct CircleResult {
  int num_scans = 0;
  int num_labels = 0;
  int num_found = 0;            ///< labels with a circle's centre within 0.10 m, one to one
  double median_error_m = 0.0;  ///< of those centres
  int num_unmatched = 0;        ///< circles that look like a column of this hall but lie near no label
};

/// Circles in a labelled recording. A circle counts as unmatched if it has at least 8 beams and 0.2 < r < 0.5
/// m and lies farther than 0.35 m from every label and every place in `maybe`, which are neither right nor
/// wrong.
CircleResult circles_in_recording(const std::filesystem::path& log, const Labels& labels, const Labels& maybe,
                                  const DetectorOptions& options);

struct LegResult {
  int num_scans = 0;
  int num_labels = 0;
  int num_found = 0;       ///< labels with a leg within 0.15 m, one to one
  int num_detections = 0;  ///< legs within 5 m
};

/// Legs in a recording; only people in a sector ahead are labelled, so what lies elsewhere is counted, not
/// judged.
LegResult legs_in_recording(const std::filesystem::path& log, const Labels& labels,
                            const DetectorOptions& options, const LegForest& forest = trained_leg_forest());

struct ScoredLeg {
  int scan = 0;
  double score = 0.0;
};

/// Legs of the robust preset by score, where all that are some are labelled: well within 15 degrees of
/// straight ahead, and 5 m. Right are those within 0.15 m of a label.
ScoreBins binned_legs(const std::filesystem::path& log, const Labels& labels, const LegForest& forest);

/// Scores of all legs within 5 m.
std::vector<ScoredLeg> scored_legs(const std::filesystem::path& log, const DetectorOptions& options,
                                   const LegForest& forest);

}  // namespace scanbed::bench
