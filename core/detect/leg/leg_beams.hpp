// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/scan/beam_directions.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Sums over the echoes before one, in the sensor frame S; z = x^2 + y^2 and step is the difference of range
/// to the echo before. The sums over any run are differences of two.
struct EchoSums {
  double x = 0.0, y = 0.0, range = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0, range2 = 0.0, step2 = 0.0;
  double xz = 0.0, yz = 0.0, zz = 0.0;
};

/// A scan as the search for legs reads it: each beam, and the echoes alone.
struct LegBeams {
  static constexpr float kNothing_m = 1e3F;  ///< range of a beam without echo, and its coordinates

  // Of each beam, then padding without echoes, so that whole blocks can be read.
  std::vector<float> range_m, x_m, y_m;

  // Of each echo, in the order of beams; sums has one entry more.
  std::vector<int> beam;
  std::vector<double> echo_range_m, echo_x_m, echo_y_m;
  std::vector<EchoSums> sums;

  int num_beams = 0;
  double step_rad = 0.0;  ///< between neighbouring beams, positive

  int num_echoes() const { return static_cast<int>(beam.size()); }
  double distance_m(int a, int b) const;  ///< between two echoes
};

/// Fills LegBeams from scans; keeps the beams' directions while the geometry stays the same.
class LegBeamReader {
 public:
  static constexpr int kBlock = 8;  ///< beams are padded to a multiple of this, and by one block more

  /// Ranges that are not positive and finite count as no echo.
  void read(const LaserScan& scan, LegBeams& beams);

 private:
  BeamDirections directions_;
};

}  // namespace scanbed
