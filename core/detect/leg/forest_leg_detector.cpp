// SPDX-License-Identifier: MIT
#include "core/detect/leg/forest_leg_detector.hpp"

#include <algorithm>

#include "core/detect/leg/keep_best_legs.hpp"

namespace scanbed {

void ForestLegDetector::detect(const LaserScan& scan, const LegForest& forest, const LegOptions& options,
                               std::vector<Leg>& legs) {
  beam_reader_.read(scan, beams_);
  finder_.find(beams_, candidates_);
  feature_reader_.read(beams_, candidates_, table_);
  scorer_.score(forest, table_, feature_reader_.places(), sums_);
  found_.clear();
  for (std::size_t i = 0; i < candidates_.runs.size(); ++i) {
    if (sums_[i] == LegForestScorer::kGivenUp) continue;
    const double score = forest.probability(sums_[i]);
    if (score < options.min_score) continue;
    const EchoRun& run = candidates_.runs[i];
    found_.push_back({{beams_.beam[run.first], beams_.beam[run.last]}, centroid_m(beams_, run), score});
  }
  keep_best_legs(found_);
  std::sort(found_.begin(), found_.end(),
            [](const Leg& a, const Leg& b) { return a.beams.first < b.beams.first; });
  legs.insert(legs.end(), found_.begin(), found_.end());
}

}  // namespace scanbed
