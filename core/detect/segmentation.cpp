// SPDX-License-Identifier: MIT
#include "core/detect/segmentation.hpp"

namespace scanbed {

void segment_points(const Points& points, const SegmentationOptions& options,
                    std::vector<Segment>& segments) {
  segments.clear();
  const double max_gap_m2 = options.max_gap_m * options.max_gap_m;
  const auto belongs_to_previous = [&](int k) {
    return points.beam[k] == points.beam[k - 1] + 1 && (points[k] - points[k - 1]).squaredNorm() < max_gap_m2;
  };
  const int num_points = points.size();
  for (int first = 0; first < num_points;) {
    int next = first + 1;
    while (next < num_points && belongs_to_previous(next)) ++next;
    if (next - first >= options.min_points) segments.push_back({first, next - 1});
    first = next;
  }
}

}  // namespace scanbed
