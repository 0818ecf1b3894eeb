// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/scan/truth.hpp"
#include "sim/planar/ray_caster.hpp"

namespace scanbed::sim {

/// What one of the rays met that stand for a spot with an edge in it.
struct SpotReturn {
  double weight = 0.0;   ///< share of the spot's light; the rays of a spot sum up to 1
  double range_m = 0.0;  ///< along the beam; kNoEcho where it met nothing
  double cos_incidence = 1.0;
  int object = kNoObject;
};

/// The rays of one beam's spot, in IdealReturns::spot_returns.
struct SplitSpot {
  int beam = 0;
  int first = 0;  ///< index of its first ray
  int count = 0;
};

/// What the beams of a scan truly meet, before any error of the sensor: the axis of every beam and, where a
/// beam's spot may have an edge in it, more rays. Any engine can fill it.
struct IdealReturns {
  // Of the beams' axes, by beam.
  std::vector<double> range_m;  ///< kNoEcho where it met nothing
  std::vector<double> cos_incidence;
  std::vector<int> object;  ///< kNoObject where it met nothing

  std::vector<SplitSpot> split_spots;  ///< at most one a beam, in any order
  std::vector<SpotReturn> spot_returns;

  /// Of so many beams that meet nothing; keeps its storage.
  void reset(int num_beams);

  /// Takes over what the axes of a caster's beams met.
  void take_axes(const RayCaster& caster);
};

}  // namespace scanbed::sim
