// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "core/score/match_options.hpp"
#include "core/score/tally.hpp"
#include "core/score/track_scorer.hpp"

namespace scanbed {

/// Compares features with truth, scan by scan, and pools the counts.
///
/// Truth is the visible part of each object, from per-beam labels; resolvable objects must be found, marginal
/// ones are neither hit nor miss, hidden ones are no truth (see classify_visibility).
class Scorer {
 public:
  /// @throws InputError where the options do not validate.
  explicit Scorer(const MatchOptions& options = {});

  /// @pre truth belongs to `scan` and features were detected in it.
  void add(const Features& features, const LaserScan& scan, const Truth& truth);

  /// Adds what was followed, scan after scan of one run.
  void add_tracks(const std::vector<Track>& tracks, const LaserScan& scan, const Truth& truth);

  Scores scores() const;

 private:
  MatchOptions options_;
  Scores scores_;
  TrackScorer people_;
  TrackScorer cylinders_;
  std::optional<double> last_time_s_;  ///< of the tracks added last
};

}  // namespace scanbed
