// SPDX-License-Identifier: MIT
#include "core/detect/points.hpp"

namespace scanbed {

void Points::clear() {
  x_m.clear();
  y_m.clear();
  beam.clear();
}

void PointProjector::project(const LaserScan& scan, Points& points) {
  directions_.follow(scan);
  points.clear();
  for (int i = 0; i < scan.num_beams(); ++i) {
    if (!scan.has_echo(i)) continue;
    points.x_m.push_back(scan.range_m[i] * directions_.x(i));
    points.y_m.push_back(scan.range_m[i] * directions_.y(i));
    points.beam.push_back(i);
  }
}

}  // namespace scanbed
