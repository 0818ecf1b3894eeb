// SPDX-License-Identifier: MIT
#include "core/interpret/corners.hpp"

#include <algorithm>

#include "core/detect/line_corner.hpp"
#include "core/interpret/piece_order.hpp"

namespace scanbed {

void find_corners(const std::vector<Line>& lines, const LaserScan& scan, const InterpretOptions& options,
                  Scene& scene) {
  const int num_lines = static_cast<int>(lines.size());
  const PieceOrder order(scan, num_lines);
  for (int i = 0; i < num_lines; ++i) {
    if (order.num_after(i) == 0) continue;
    const int k = order.after(i, 1);
    const NeighbouringLines pair{lines[i], lines[k], order.between(lines[i], lines[k])};
    const auto corner_m = corner_of(pair, scan.geometry, {options.min_corner_rad, options.corner_reach_m});
    if (!corner_m) continue;
    const Eigen::Vector2d into_walls =
        (lines[i].left_m - *corner_m).normalized() + (lines[k].right_m - *corner_m).normalized();
    scene.objects.push_back({.kind = SceneKind::kCorner,
                             .center_m = *corner_m,
                             .is_outer = into_walls.dot(*corner_m) > 0.0,
                             .score = std::min(lines[i].score, lines[k].score),
                             .first_from = static_cast<int>(scene.from.size()),
                             .num_from = 2});
    scene.from.push_back({Primitive::kLine, i});
    scene.from.push_back({Primitive::kLine, k});
  }
}

}  // namespace scanbed
