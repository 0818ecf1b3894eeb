// SPDX-License-Identifier: MIT
#include "core/detect/leg/forest_leg_detector.hpp"

#include <algorithm>
#include <tuple>

namespace scanbed {
namespace {

constexpr double kApart_m = 0.10;  // between the middles of two legs

bool are_one(const Leg& a, const Leg& b) {
  const bool overlap = a.beams.first <= b.beams.last && b.beams.first <= a.beams.last;
  return overlap || (a.middle_m - b.middle_m).squaredNorm() < kApart_m * kApart_m;
}

}  // namespace

// Non-maximum suppression: takes the best, drops what is one with it, and so on.
void ForestLegDetector::keep_best(std::vector<Leg>& legs) {
  std::sort(found_.begin(), found_.end(), [](const Leg& a, const Leg& b) {
    return std::tie(b.score, a.beams.first, a.beams.last) < std::tie(a.score, b.beams.first, b.beams.last);
  });
  const auto first_new = static_cast<std::ptrdiff_t>(legs.size());
  for (const Leg& leg : found_) {
    const bool is_known = std::any_of(legs.begin() + first_new, legs.end(),
                                      [&](const Leg& known) { return are_one(leg, known); });
    if (!is_known) legs.push_back(leg);
  }
  std::sort(legs.begin() + first_new, legs.end(),
            [](const Leg& a, const Leg& b) { return a.beams.first < b.beams.first; });
}

void ForestLegDetector::detect(const LaserScan& scan, const LegForest& forest, const LegOptions& options,
                               std::vector<Leg>& legs) {
  beam_reader_.read(scan, beams_);
  finder_.find(beams_, candidates_);
  feature_reader_.read(beams_, candidates_, table_);
  scorer_.score(forest, table_, sums_);
  found_.clear();
  for (std::size_t i = 0; i < candidates_.runs.size(); ++i) {
    if (sums_[i] == LegForestScorer::kGivenUp) continue;
    const double score = forest.probability(sums_[i]);
    if (score < options.min_score) continue;
    const EchoRun& run = candidates_.runs[i];
    found_.push_back({{beams_.beam[run.first], beams_.beam[run.last]}, centroid_m(beams_, run), score});
  }
  keep_best(legs);
}

}  // namespace scanbed
