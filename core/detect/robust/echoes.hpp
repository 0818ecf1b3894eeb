// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/detect/robust/surface_options.hpp"
#include "core/scan/beam_directions.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// The echoes of a scan with their errors, sensor frame S: in the order of their beams as they are read, then
/// surface by surface (SurfaceSplitter).
struct Echoes {
  std::vector<int> beam;
  std::vector<double> range_m;
  std::vector<double> x_m, y_m;         ///< the point
  std::vector<double> weight_per_m2;    ///< 1 / variance of the range
  BeamDirections directions;            ///< of all beams of the scan
  double step_rad = 0.0;                ///< between neighbouring beams, positive
  int num_beams_to_same_direction = 0;  ///< so many beams on, a beam points the same way again
  double range_noise_m = 0.0;           ///< sigma of a range on a plain surface near the sensor
  double noise_ratio = 0.0;             ///< sigma of what is added at a range, over that range

  int size() const { return static_cast<int>(beam.size()); }
  Eigen::Vector2d point_m(int k) const { return {x_m[k], y_m[k]}; }
  /// Of a range on a plain surface so far away.
  double variance_at_m2(double distance_m) const {
    const double grown_m = noise_ratio * distance_m;
    return range_noise_m * range_noise_m + grown_m * grown_m;
  }
  double sigma_m(int k) const { return 1.0 / std::sqrt(weight_per_m2[k]); }  ///< of the range
};

/// Median of third differences of range, by counting.
class NoiseHistogram {
 public:
  static constexpr int kNumBins = 512;
  static constexpr int kNoBin = kNumBins;  ///< of what is no noise

  explicit NoiseHistogram(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  /// Sigma of the ranges of neighbouring beams, from their smooth runs; empty where those are too few to
  /// tell. A sigma of more than `greatest_m` comes out too small.
  std::optional<double> sigma_m(std::span<const double> range_m, double greatest_m);

 private:
  void sort_into_bins(std::span<const double> range_m);
  void count();
  double median_m() const;

  using Counts = std::array<int, kNumBins + 1>;
  InstructionSet instructions_;
  // Neighbours often share their bin; in two tables one count need not wait for the other.
  std::array<Counts, 2> counts_{};
  std::vector<int> bins_;
  int num_counted_ = 0;
  double greatest_m_ = 0.0;
};

/// Fills `echoes` from a scan: points, the scan's own range noise, and the error of each range. What is 300 m
/// away or farther is no echo.
///
/// Range noise is estimated from third differences of range along smooth runs. At grazing incidence a small
/// error of direction is a large error of range: sigma grows with the step to the neighbours where both point
/// the same way.
/// @par Source  Noise: rms of third differences / sqrt(20) for white noise (1, 3, 3, 1 squared and summed).
class EchoReader {
 public:
  explicit EchoReader(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions), noise_(instructions) {}

  void read(const LaserScan& scan, const SurfaceOptions& options, Echoes& echoes);

 private:
  void weigh(Echoes& echoes);

  InstructionSet instructions_;
  NoiseHistogram noise_;
  std::vector<int> grazing_;  ///< echoes at grazing incidence, and room
};

}  // namespace scanbed
