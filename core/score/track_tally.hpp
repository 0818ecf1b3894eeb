// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace scanbed {

/// How well tracks followed what there was to follow, pooled over scans and runs.
///
/// @par Source  Bernardin & Stiefelhagen, "Evaluating multiple object tracking performance: the CLEAR MOT
///              metrics", 2008; IDF1: Ristani et al., "Performance measures and a data set for multi-target,
///              multi-camera tracking", 2016.
struct TrackTally {
  int num_truths = 0;           ///< resolvable objects, summed over the scans
  int num_matches = 0;          ///< of them, those with a track within the gate
  int num_false = 0;            ///< tracks on nothing, summed over the scans
  int num_neither = 0;          ///< tracks on what need not be found
  int num_switches = 0;         ///< times at which an object's track became another one
  double sum_error_m = 0.0;     ///< distances of the matches
  double object_time_s = 0.0;   ///< how long objects were in view, summed over the objects
  int num_identity_true = 0;    ///< scans in which an object has the one track that is its own in all
  int num_identity_tracks = 0;  ///< scans of all tracks that are right or wrong

  // Empty where there is nothing to measure them by.
  /// (truths - misses - false - switches) / truths.
  std::optional<double> mota() const;
  /// Mean distance of the matches.
  std::optional<double> motp_m() const;
  /// 2 IDTP / (truths + tracks).
  std::optional<double> idf1() const;
  /// For each minute of each object in view.
  std::optional<double> switches_per_minute() const;
  TrackTally& operator+=(const TrackTally& other);
};

}  // namespace scanbed
