// SPDX-License-Identifier: MIT
#include "core/detect/leg/forest_leg_detector.hpp"

#include <algorithm>

#include "core/detect/leg/keep_best_legs.hpp"
#include "core/detect/leg_detector.hpp"

namespace scanbed {

void ForestLegDetector::detect(const LaserScan& scan, const Features& surfaces, const LegOptions& options,
                               Features& features) {
  beam_reader_.read(scan, beams_);
  finder_.find(beams_, candidates_);
  feature_reader_.read(beams_, candidates_, surfaces, table_);
  scorer_.score(*forest_, table_, feature_reader_.places(), sums_);
  found_.clear();
  const double least_score = std::min(options.min_score, options.min_doubtful_score);
  for (std::size_t i = 0; i < candidates_.runs.size(); ++i) {
    if (sums_[i] == LegForestScorer::kGivenUp) continue;
    const double score = forest_->probability(sums_[i]);
    if (score < least_score) continue;
    const EchoRun& run = candidates_.runs[i];
    found_.push_back({{beams_.beam[run.first], beams_.beam[run.last]}, centroid_m(beams_, run), score});
  }
  keep_best_legs(found_);
  std::sort(found_.begin(), found_.end(),
            [](const Leg& a, const Leg& b) { return a.beams.first < b.beams.first; });
  for (const Leg& leg : found_) append_by_score(leg, options, features);
}

}  // namespace scanbed
