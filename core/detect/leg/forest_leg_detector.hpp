// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/leg/leg_beams.hpp"
#include "core/detect/leg/leg_candidates.hpp"
#include "core/detect/leg/leg_features.hpp"
#include "core/detect/leg/leg_forest.hpp"

namespace scanbed {

/// Legs by a boosted forest: candidates from three segmentations, scored by their shape, the circle
/// they lie on and their surroundings, the best of those that overlap or lie within 0.10 m of each other.
/// Keeps its buffers.
class ForestLegDetector {
 public:
  /// @param forest  lives as long as the detector.
  explicit ForestLegDetector(const LegForest& forest) : forest_(&forest) {}

  /// Appends the legs, and those that are doubtful, in rising order of their first beam. A leg's middle is
  /// the centroid of its echoes; its score the calibrated probability that it is one.
  ///
  /// @param surfaces  circles of this scan, as the robust pipeline finds them; may be `features` itself.
  void detect(const LaserScan& scan, const Features& surfaces, const LegOptions& options, Features& features);

 private:
  const LegForest* forest_;
  LegBeamReader beam_reader_;
  LegBeams beams_;
  LegCandidateFinder finder_;
  LegCandidates candidates_;
  LegFeatureReader feature_reader_;
  LegFeatureTable table_;
  LegForestScorer scorer_;
  std::vector<float> sums_;
  std::vector<Leg> found_;
};

}  // namespace scanbed
