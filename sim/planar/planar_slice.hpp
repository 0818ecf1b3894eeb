// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace scanbed::sim {

/// A straight piece of surface in the laser's plane.
struct SliceSegment {
  Eigen::Vector2d a_m = Eigen::Vector2d::Zero();  ///< p_LA
  Eigen::Vector2d b_m = Eigen::Vector2d::Zero();  ///< p_LB
  int object = 0;
  double steepness_ratio =
      1.0;  ///< cosine between the surface's normal and the laser's plane; 1: at right angles
};

/// A round surface in the laser's plane.
struct SliceDisc {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< p_LC
  double radius_m = 0.0;
  int object = 0;
  double steepness_ratio = 1.0;  ///< as of a segment
};

/// Where the laser's plane cuts a round body askew: a piece of a conic, not necessarily closed. With q from
/// `center_m`, it is those points of q' form q + 2 slope' q = level that have from <= along' q <= to.
struct SliceArc {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< p_LC; of a leg: on its axis
  Eigen::Matrix2d form = Eigen::Matrix2d::Identity();  ///< symmetric, no eigenvalue negative
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double level = 0.0;
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  /// Length of the body's own normal (in space) where form q + slope is that normal's part in the plane: its
  /// radius, for a cylinder or a sphere. 0: the normal lies in the plane.
  double normal = 0.0;
  int object = 0;
};

/// What the laser's plane cuts out of a world at one moment, in a frame L of that plane (see Engine).
/// `object` counts as Engine::objects does.
struct PlanarSlice {
  std::vector<SliceSegment> segments;
  std::vector<SliceDisc> discs;
  std::vector<SliceArc> arcs;
};

}  // namespace scanbed::sim
