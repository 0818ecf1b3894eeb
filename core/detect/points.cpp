// SPDX-License-Identifier: MIT
#include "core/detect/points.hpp"

#include <cmath>

namespace scanbed {

void Points::clear() {
  x_m.clear();
  y_m.clear();
  beam.clear();
}

void PointProjector::tabulate(const ScanGeometry& geometry, int num_beams) {
  geometry_ = geometry;
  geometry_.num_beams = num_beams;
  cos_.resize(num_beams);
  sin_.resize(num_beams);
  for (int i = 0; i < num_beams; ++i) {
    cos_[i] = std::cos(geometry.bearing_rad(i));
    sin_[i] = std::sin(geometry.bearing_rad(i));
  }
}

void PointProjector::project(const LaserScan& scan, Points& points) {
  const ScanGeometry& g = scan.geometry;
  const int num_beams = scan.num_beams();
  // The ranges count, not geometry.num_beams: a scan that promises more beams than it holds must not be read
  // past.
  if (geometry_.num_beams != num_beams || geometry_.first_rad != g.first_rad ||
      geometry_.step_rad != g.step_rad) {
    tabulate(g, num_beams);
  }
  points.clear();
  for (int i = 0; i < num_beams; ++i) {
    if (!scan.has_echo(i)) continue;
    points.x_m.push_back(scan.range_m[i] * cos_[i]);
    points.y_m.push_back(scan.range_m[i] * sin_[i]);
    points.beam.push_back(i);
  }
}

}  // namespace scanbed
