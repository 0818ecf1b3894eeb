// SPDX-License-Identifier: MIT
#include "sim/world/solid_geometry.hpp"

#include <algorithm>
#include <limits>

#include "core/geometry/cross.hpp"
#include "core/geometry/segment_distance.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

std::vector<Edge> edges_along(const std::vector<Vector2d>& corners_m, bool closed) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i + 1 < corners_m.size(); ++i) edges.push_back({corners_m[i], corners_m[i + 1]});
  if (closed && corners_m.size() > 2) edges.push_back({corners_m.back(), corners_m.front()});
  return edges;
}

std::vector<Vector2d> corners_of(const Box& box) {
  const Vector2d half = 0.5 * box.size_m;
  return {box.X_WB * Vector2d(-half.x(), -half.y()), box.X_WB * Vector2d(half.x(), -half.y()),
          box.X_WB * Vector2d(half.x(), half.y()), box.X_WB * Vector2d(-half.x(), half.y())};
}

struct Outline {
  std::vector<Edge> operator()(const WallChain& chain) const {
    return edges_along(chain.corners_m, chain.closed);
  }
  std::vector<Edge> operator()(const Cylinder&) const { return {}; }
  std::vector<Edge> operator()(const Box& box) const { return edges_along(corners_of(box), true); }
  std::vector<Edge> operator()(const Polygon& polygon) const { return edges_along(polygon.corners_m, true); }
};

// Of a convex outline that runs counter-clockwise.
bool is_inside(const std::vector<Edge>& edges, const Vector2d& p_WQ) {
  return std::all_of(edges.begin(), edges.end(),
                     [&](const Edge& edge) { return cross(edge.b_m - edge.a_m, p_WQ - edge.a_m) > 0.0; });
}

}  // namespace

std::vector<Edge> outline(const SolidShape& shape) {
  return std::visit(Outline{}, shape);
}

double distance_m(const Edge& edge, const Vector2d& p_WQ) {
  return segment_distance_m(p_WQ, edge.a_m, edge.b_m);
}

bool crosses(const Edge& edge, const Vector2d& p_WP, const Vector2d& p_WQ) {
  const Vector2d along = edge.b_m - edge.a_m;
  const Vector2d way = p_WQ - p_WP;
  const bool ends_apart = cross(way, edge.a_m - p_WP) * cross(way, edge.b_m - p_WP) < 0.0;
  return ends_apart && cross(along, p_WP - edge.a_m) * cross(along, p_WQ - edge.a_m) < 0.0;
}

ShapeOutline::ShapeOutline(const SolidShape& shape)
    : is_filled_(!std::holds_alternative<WallChain>(shape)), edges_(outline(shape)) {
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    center_m_ = cylinder->center_m;
    radius_m_ = cylinder->radius_m;
    bounds_.extend(center_m_ - Vector2d::Constant(radius_m_));
    bounds_.extend(center_m_ + Vector2d::Constant(radius_m_));
  }
  for (const Edge& edge : edges_) {
    bounds_.extend(edge.a_m);
    bounds_.extend(edge.b_m);
  }
}

double ShapeOutline::clearance_m(const Vector2d& p_WQ) const {
  if (radius_m_ > 0.0) return (p_WQ - center_m_).norm() - radius_m_;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) nearest_m = std::min(nearest_m, distance_m(edge, p_WQ));
  return is_filled_ && is_inside(edges_, p_WQ) ? -nearest_m : nearest_m;
}

double clearance_m(const SolidShape& shape, const Vector2d& p_WQ) {
  return ShapeOutline(shape).clearance_m(p_WQ);
}

}  // namespace scanbed::sim
