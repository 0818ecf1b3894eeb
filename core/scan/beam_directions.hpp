// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Unit directions of a scan's beams in the sensor frame S, kept while the geometry stays the same.
class BeamDirections {
 public:
  /// Takes over the geometry of `scan`, for as many beams as it has ranges: a scan that promises more beams
  /// than it holds must not be read past.
  void follow(const LaserScan& scan);

  int num_beams() const { return static_cast<int>(x_.size()); }
  double x(int beam) const { return x_[beam]; }
  double y(int beam) const { return y_[beam]; }
  /// Of all beams, in their order.
  std::span<const double> x() const { return x_; }
  std::span<const double> y() const { return y_; }

 private:
  void tabulate(const ScanGeometry& geometry, int num_beams);

  double first_rad_ = 0.0;
  double step_rad_ = 0.0;
  std::vector<double> x_, y_;
};

}  // namespace scanbed
