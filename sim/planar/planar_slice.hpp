// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace scanbed::sim {

/// A straight piece of surface in the laser's plane.
struct SliceSegment {
  Eigen::Vector2d a_m = Eigen::Vector2d::Zero();  ///< p_LA
  Eigen::Vector2d b_m = Eigen::Vector2d::Zero();  ///< p_LB
  int object = 0;
};

/// A round surface in the laser's plane.
struct SliceDisc {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< p_LC
  double radius_m = 0.0;
  int object = 0;
};

/// What the laser's plane cuts out of a world at one moment, in a frame L of that plane (see Engine).
/// `object` counts as Engine::objects does.
struct PlanarSlice {
  std::vector<SliceSegment> segments;
  std::vector<SliceDisc> discs;
};

}  // namespace scanbed::sim
