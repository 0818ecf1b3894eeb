// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/detect/robust/surface_options.hpp"
#include "core/scan/beam_directions.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// The echoes of a scan with their directions and errors, in the order of their beams; sensor frame S.
struct Echoes {
  std::vector<int> beam;
  std::vector<double> range_m;
  std::vector<double> ux, uy;                       ///< unit direction of the beam
  std::vector<double> x_m, y_m;                     ///< the point
  std::vector<double> sigma_m;                      ///< standard deviation of the range
  double step_rad = 0.0;                            ///< between neighbouring beams, positive
  Eigen::Vector2d step = Eigen::Vector2d::UnitX();  ///< (cos, sin) of the signed step
  double range_noise_m = 0.0;                       ///< sigma of a range on a plain surface

  int size() const { return static_cast<int>(beam.size()); }
  Eigen::Vector2d point_m(int k) const { return {x_m[k], y_m[k]}; }
};

/// Median of third differences of range, by counting.
class NoiseHistogram {
 public:
  void clear();
  void add(double difference_m);

  /// Sigma of the ranges whose differences were added; empty where they are too few to tell.
  std::optional<double> sigma_m() const;

 private:
  static constexpr int kNumBins = 512;
  std::array<int, kNumBins> counts_{};
  int num_counted_ = 0;
};

/// Fills `echoes` from a scan: directions, the scan's own range noise, and the error of each range.
///
/// Range noise is estimated from third differences of range along smooth runs. At grazing incidence a small
/// error of direction is a large error of range: sigma grows with the step to the neighbours where both point
/// the same way.
/// @par Source  Noise: rms of third differences / sqrt(20) for white noise (1, 3, 3, 1 squared and summed).
class EchoReader {
 public:
  void read(const LaserScan& scan, const SurfaceOptions& options, Echoes& echoes);

 private:
  void estimate_noise(const SurfaceOptions& options, Echoes& echoes);
  void spread_noise(Echoes& echoes) const;

  BeamDirections directions_;
  NoiseHistogram noise_;
};

}  // namespace scanbed
