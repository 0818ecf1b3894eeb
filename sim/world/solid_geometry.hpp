// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// A straight piece of outline, p_WA to p_WB.
struct Edge {
  Eigen::Vector2d a_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d b_m = Eigen::Vector2d::Zero();
};

/// Outline of a shape, in the order in which truth counts it; empty for a cylinder. Neighbouring edges share
/// their corner to the bit.
std::vector<Edge> outline(const SolidShape& shape);

/// Distance from a point p_WQ to an edge, metres; edges of length 0 are points.
double distance_m(const Edge& edge, const Eigen::Vector2d& p_WQ);

/// Whether the straight way from p_WP to p_WQ crosses the edge; merely touching it is no crossing.
bool crosses(const Edge& edge, const Eigen::Vector2d& p_WP, const Eigen::Vector2d& p_WQ);

/// A shape that is asked often: its outline and bounds are made once.
class ShapeOutline {
 public:
  explicit ShapeOutline(const SolidShape& shape);

  const std::vector<Edge>& edges() const { return edges_; }
  const Eigen::AlignedBox2d& bounds() const { return bounds_; }

  /// Distance from a point p_WQ to the nearest matter of the shape, metres; negative inside a cylinder, box
  /// or polygon, where its size is the distance to the outline. A chain of walls has no inside.
  double clearance_m(const Eigen::Vector2d& p_WQ) const;

 private:
  Eigen::Vector2d center_m_ = Eigen::Vector2d::Zero();
  double radius_m_ = 0.0;  ///< 0: no cylinder
  bool is_filled_;
  std::vector<Edge> edges_;
  Eigen::AlignedBox2d bounds_;
};

/// ShapeOutline::clearance_m() of a shape that is asked once.
double clearance_m(const SolidShape& shape, const Eigen::Vector2d& p_WQ);

/// Whether the solid has matter at this height above the floor.
inline bool is_at_height(const Solid& solid, double height_m) {
  return solid.bottom_m <= height_m && height_m <= solid.top_m;
}

}  // namespace scanbed::sim
