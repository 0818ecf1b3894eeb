// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/geometry/pose2.hpp"
#include "core/scan/scan_geometry.hpp"
#include "sim/planar/planar_slice.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/planar/spot_caster.hpp"

namespace scanbed::sim {

/// Leaves out of a slice what no beam of a sector can meet, so that several casters, each of a part of the
/// view, do not each look at all shapes. The beams meet the same as in the whole slice, to the bit.
///
/// What lies wholly to the right of the sector's first beam, or wholly to the left of its last one, is out.
/// Sectors of half a turn and more keep everything, and so do arcs.
class SectorCuller {
 public:
  /// @param spot  of the beams; the default is a ray.
  /// @pre as of RayCaster.
  SectorCuller(const ScanGeometry& geometry, BeamSubset subset, const Spot& spot);

  /// @returns what is left, in the same order; valid until the next call, or as long as `slice`.
  const PlanarSlice& cull(const PlanarSlice& slice, const Pose2& X_LS);

 private:
  bool is_all_;                   ///< the sector is too wide for sides
  Eigen::Vector2d right_, left_;  ///< directions of the first and the last beam, sensor frame
  double half_spot_m_;
  double spot_ratio_;  ///< by which half a spot grows with range, at most
  PlanarSlice rest_;
};

}  // namespace scanbed::sim
