// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// A walker's path by arc length: straight pieces joined by arcs of radius Path::round_m.
///
/// A loop starts behind the arc of its first corner. At a sharp corner the position turns at once, while
/// the heading turns evenly from 0.15 m before to 0.15 m behind (on shorter pieces from half their length):
/// nobody's hips flip over. (The start of a loop is such a corner from the second time round.)
class RoundedPath {
 public:
  /// @pre validate_path accepts it.
  explicit RoundedPath(const Path& path);

  /// From the start to the end; of a loop once round.
  double length_m() const { return length_m_; }

  /// Pose in the world, x axis along the path, `distance_m` behind the start; clamped to the ends of an open
  /// path, going round and round on a loop.
  Pose2 pose_at(double distance_m) const;

 private:
  /// Straight where the curvature is 0, else an arc.
  struct Piece {
    double start_m;  ///< arc length before it
    double length_m;
    Eigen::Vector2d p_WA;           ///< its first point
    double heading_rad;             ///< at its first point
    Eigen::Vector2d along;          ///< likewise, as a unit vector
    double curvature_per_m;         ///< positive to the left
    double sharp_before_rad = 0.0;  ///< turn at the sharp corner before it
    double sharp_behind_rad = 0.0;
  };

  void add(const Piece& piece);

  std::vector<Piece> pieces_;
  double length_m_ = 0.0;
  bool loop_ = false;
};

/// @throws InputError, its message beginning with `name`, where the path has fewer than 2 points, a point
///         that is not finite, two equal neighbours, or a radius that is negative or does not fit between
///         the corners.
void validate_path(const Path& path, std::string_view name);

}  // namespace scanbed::sim
