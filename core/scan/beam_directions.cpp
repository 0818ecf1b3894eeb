// SPDX-License-Identifier: MIT
#include "core/scan/beam_directions.hpp"

#include <cmath>

namespace scanbed {

void BeamDirections::follow(const LaserScan& scan) {
  const ScanGeometry& geometry = scan.geometry;
  if (num_beams() == scan.num_beams() && geometry.first_rad == first_rad_ && geometry.step_rad == step_rad_) {
    return;
  }
  tabulate(geometry, scan.num_beams());
}

void BeamDirections::tabulate(const ScanGeometry& geometry, int num_beams) {
  first_rad_ = geometry.first_rad;
  step_rad_ = geometry.step_rad;
  x_.resize(num_beams);
  y_.resize(num_beams);
  for (int i = 0; i < num_beams; ++i) {
    x_[i] = std::cos(geometry.bearing_rad(i));
    y_[i] = std::sin(geometry.bearing_rad(i));
  }
}

}  // namespace scanbed
