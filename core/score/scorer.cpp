// SPDX-License-Identifier: MIT
#include "core/score/scorer.hpp"

#include <algorithm>

#include "core/errors/ensure.hpp"
#include "core/score/match_lines.hpp"
#include "core/score/match_round.hpp"

namespace scanbed {
namespace {

const MatchOptions& validated(const MatchOptions& options) {
  options.validate();
  return options;
}

}  // namespace

Scorer::Scorer(const MatchOptions& options)
    : options_(validated(options)),
      people_(TrackKind::kPerson, options.person_m),
      cylinders_(TrackKind::kCylinder, options.cylinder_m) {}

void Scorer::add_tracks(const std::vector<Track>& tracks, const LaserScan& scan, const Truth& truth) {
  const double dt_s = last_time_s_ ? std::max(0.0, scan.time_s - *last_time_s_) : 0.0;
  last_time_s_ = scan.time_s;
  people_.add(people_of(truth), tracks, dt_s);
  cylinders_.add(cylinders_of(truth), tracks, dt_s);
}

Scores Scorer::scores() const {
  Scores scores = scores_;
  if (last_time_s_) {
    scores.person = people_.tally();
    scores.cylinder = cylinders_.tally();
  }
  return scores;
}

void Scorer::add(const Features& features, const LaserScan& scan, const Truth& truth) {
  SCANBED_ENSURE(truth.beams.size() == scan.range_m.size());
  ++scores_.num_scans;
  scores_.line += match_lines(features.lines, scan, truth, options_);
  scores_.circle += match_circles(features.circles, truth, options_);
  scores_.leg += match_legs(features.legs, truth, options_);
}

}  // namespace scanbed
