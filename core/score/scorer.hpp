// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/truth.hpp"

namespace scanbed {

/// When a detection is the truth it is compared with.
struct MatchOptions {
  double line_angle_rad = 0.0523598775598;  ///< 3 degrees
  double line_offset_m = 0.05;              ///< perpendicular to the wall
  double line_overlap_ratio = 0.5;          ///< of the visible span that detected lines must cover
  double circle_center_m = 0.10;
  double circle_radius_m = 0.05;
  double leg_center_m = 0.15;
  double narrow_cylinder_m =
      0.125;              ///< a leg on a true cylinder of smaller radius is neither right nor wrong
  void validate() const;  ///< @throws InputError naming the first field out of range
};

/// Counts of one kind of feature, pooled over scans.
struct Tally {
  int num_truths = 0;      ///< resolvable objects
  int num_found = 0;       ///< resolvable objects that a detection matched
  int num_detections = 0;  ///< detections that are right or wrong; those on marginal truth are not counted
  int num_right = 0;       ///< detections that matched a truth
  double sum_squared_error_m2 = 0.0;  ///< of matched centres (lines: of perpendicular offsets)
  int num_errors = 0;                 ///< how many squared errors were summed

  /// num_right / num_detections; 1 where nothing was detected, since nothing detected is wrong.
  double precision() const;
  /// num_found / num_truths; 1 where there is nothing to find.
  double recall() const;
  double rms_error_m() const;  ///< 0 where nothing matched
  Tally& operator+=(const Tally& other);
};

/// Recall within a band of ranges.
struct RangeBand {
  double from_m = 0.0;
  double to_m = 0.0;
  int num_truths = 0;
  int num_found = 0;
  double recall() const;
};

inline constexpr int kNumRangeBands = 5;  ///< 0-2, 2-4, 4-6, 6-8, 8+ m

/// Scores of one kind of feature.
struct KindScore {
  Tally tally;
  std::array<RangeBand, kNumRangeBands> bands;
};

/// Scores of all scans seen so far.
struct Scores {
  int num_scans = 0;
  KindScore line;
  KindScore circle;
  KindScore leg;

  /// Wrong detections per scan.
  double false_per_scan(const KindScore& kind) const;
};

/// Compares features with truth, scan by scan, and pools the counts.
///
/// Truth is the visible part of each object, from per-beam labels: see classify_visibility. Circles and legs
/// are matched one to one, nearest first; walls may be found in several pieces.
class Scorer {
 public:
  explicit Scorer(const MatchOptions& options = {});

  void add(const Features& features, const Truth& truth);
  const Scores& scores() const { return scores_; }

 private:
  MatchOptions options_;
  Scores scores_;
};

}  // namespace scanbed
