// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "core/score/track_tally.hpp"

namespace scanbed {

/// Counts of one kind of feature, pooled over scans.
struct Tally {
  int num_truths = 0;      ///< resolvable objects
  int num_found = 0;       ///< resolvable objects that a detection matched
  int num_detections = 0;  ///< detections that are right or wrong
  int num_right = 0;       ///< detections that matched a resolvable object
  int num_neither = 0;     ///< detections on marginal objects, which are neither right nor wrong
  double sum_squared_error_m2 =
      0.0;  ///< of the centres that matched (lines: of their offsets across the wall)

  /// num_right / num_detections; 1 where nothing was detected, since nothing detected is wrong.
  double precision() const;
  /// num_found / num_truths; 1 where there is nothing to find.
  double recall() const;
  /// Root mean square error of the right detections; 0 where there is none.
  double rms_error_m() const;
  Tally& operator+=(const Tally& other);
};

/// What there was to find in a band of ranges, and what of it was found.
struct RangeBand {
  double from_m = 0.0;
  double to_m = 0.0;
  int num_truths = 0;
  int num_found = 0;

  double recall() const;  ///< 1 where there is nothing to find
};

/// Scores of one kind of feature. Bands by the distance of the object from the sensor: 0-2, 2-4, 4-6, 6-8, 8-
/// m.
struct KindScore {
  Tally tally;
  std::array<RangeBand, 5> bands;

  KindScore();
  void count_truth(double distance_m, bool found);
  KindScore& operator+=(const KindScore& other);
};

/// Scores of all scans seen so far.
struct Scores {
  int num_scans = 0;
  KindScore line;
  KindScore circle;
  KindScore leg;
  std::optional<TrackTally> person;    ///< where tracks were scored
  std::optional<TrackTally> cylinder;  ///< likewise

  /// Wrong detections of a kind, or tracks on nothing, per scan; empty where there was no scan.
  std::optional<double> false_per_scan(const KindScore& kind) const;
  std::optional<double> false_per_scan(const TrackTally& tracks) const;
};

}  // namespace scanbed
