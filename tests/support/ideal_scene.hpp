// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"

namespace scanbed::testing {

/// A handful of walls and cylinders around the sensor, scanned without errors: each beam is intersected with
/// each shape in closed form, slowly and obviously. Independent of the simulation.
class IdealScene {
 public:
  explicit IdealScene(const ScanGeometry& geometry = {}) : geometry_(geometry) {}

  /// Adds a wall from a to b, metres, sensor frame. @returns its index in truth.
  int wall(Eigen::Vector2d a_m, Eigen::Vector2d b_m);
  int cylinder(Eigen::Vector2d center_m, double radius_m, Primitive primitive = Primitive::kCircle);

  LaserScan scan() const;

  /// Labels of scan(), with visibility classified.
  Truth truth() const;

 private:
  BeamTruth cast(double bearing_rad) const;

  ScanGeometry geometry_;
  std::vector<ObjectTruth> objects_;
};

/// Adds Gaussian noise to every echo, in a fixed order from a fixed seed.
LaserScan with_noise(LaserScan scan, double sigma_m, unsigned seed);

}  // namespace scanbed::testing
