// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/segmentation.hpp"
#include "core/geometry/line_fit.hpp"

namespace scanbed {

/// Lines of a segment by recursive line fitting: fit, and where the fit is bad, split at the point farthest
/// from the chord and go on with both sides, which share that point.
///
/// A run is dropped when it has fewer than min_points points or its ends are nearer than min_length_m; it is
/// a line when no point lies farther than max_error_m from its orthogonal regression. With
/// LineMethod::kInscribedAngle a run is a line when its inscribed angles average 180 degrees instead.
///
/// @par Cost    O(n log n) mean, O(n^2) worst.
/// @par Source  The paper, II-F; II-B.1 for inscribed angles.
class LineDetector {
 public:
  explicit LineDetector(const LineOptions& options) : options_(options) {}

  void set_options(const LineOptions& options) { options_ = options; }

  /// Appends the lines of `segment` to `lines`, in rising order of their beams.
  void detect(const Points& points, const Segment& segment, std::vector<Line>& lines);

 private:
  struct Fit {
    LineFit line;
    double error_m = 0.0;
  };
  void sum_moments(const Points& points, const Segment& segment);
  Fit fit(const Points& points, const Segment& run) const;
  bool accepts(const Points& points, const Segment& run, const Fit& fit) const;

  LineOptions options_;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  int origin_index_ = 0;
  std::vector<LineMoments> moments_;  // running sums about origin_m_, so that sums of squares do not cancel
  std::vector<Segment> pending_;
};

}  // namespace scanbed
