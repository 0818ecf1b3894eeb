// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/scan/beam_directions.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// The echoes of a scan as points in the sensor frame S, in the order of their beams. Point k came from
/// beam[k].
struct Points {
  std::vector<double> x_m;
  std::vector<double> y_m;
  std::vector<int> beam;

  int size() const { return static_cast<int>(beam.size()); }
  Eigen::Vector2d operator[](int k) const { return {x_m[k], y_m[k]}; }
  void clear();
};

/// Turns ranges into points. Keeps the beams' directions while the geometry stays the same.
class PointProjector {
 public:
  /// Writes the echoes of `scan` over `points`; beams without a finite range are left out.
  void project(const LaserScan& scan, Points& points);

 private:
  BeamDirections directions_;
};

}  // namespace scanbed
