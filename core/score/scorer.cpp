// SPDX-License-Identifier: MIT
#include "core/score/scorer.hpp"

#include "core/errors/ensure.hpp"
#include "core/score/match_lines.hpp"
#include "core/score/match_round.hpp"

namespace scanbed {

Scorer::Scorer(const MatchOptions& options) : options_(options) {
  options_.validate();
}

void Scorer::add(const Features& features, const LaserScan& scan, const Truth& truth) {
  SCANBED_ENSURE(truth.beams.size() == scan.range_m.size());
  ++scores_.num_scans;
  scores_.line += match_lines(features.lines, scan, truth, options_);
  scores_.circle += match_circles(features.circles, truth, options_);
  scores_.leg += match_legs(features.legs, truth, options_);
}

}  // namespace scanbed
