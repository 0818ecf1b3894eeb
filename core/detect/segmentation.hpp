// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/points.hpp"

namespace scanbed {

/// A run of neighbouring points that probably belong to one object: indices into Points, both ends included.
struct Segment {
  int first = 0;
  int last = 0;

  int num_points() const { return last - first + 1; }
};

/// Cuts a scan where the distance between neighbouring points exceeds options.max_gap_m, or a beam has no
/// echo.
///
/// @param segments  overwritten: runs in rising order, disjoint; those with fewer than options.min_points are
/// dropped.
/// @par Cost    O(N).
/// @par Source  The paper, II-A. Distances are between points, not between ranges.
void segment_points(const Points& points, const SegmentationOptions& options, std::vector<Segment>& segments);

}  // namespace scanbed
