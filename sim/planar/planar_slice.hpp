// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace scanbed::sim {

/// A straight piece of surface in the laser's plane.
struct SliceSegment {
  Eigen::Vector2d a_m = Eigen::Vector2d::Zero();  ///< p_WA
  Eigen::Vector2d b_m = Eigen::Vector2d::Zero();  ///< p_WB
  int object = 0;
};

/// A round surface in the laser's plane.
struct SliceDisc {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< p_WC
  double radius_m = 0.0;
  int object = 0;
};

/// What the laser's plane cuts out of a world at one moment, world frame. `object` counts as
/// PlanarEngine::objects does.
struct PlanarSlice {
  std::vector<SliceSegment> segments;
  std::vector<SliceDisc> discs;
};

}  // namespace scanbed::sim
