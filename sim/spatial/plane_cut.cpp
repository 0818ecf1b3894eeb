// SPDX-License-Identifier: MIT
#include "sim/spatial/plane_cut.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/errors/ensure.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFloorReach_m = 1e4;

/// A round body in the sensor frame, whose plane z = 0 cuts it.
struct InSensorFrame {
  Vector3d p_SC;
  Vector3d axis_S;
  double sine;  ///< of the angle between axis and the plane's normal

  InSensorFrame(const LaserPlane& plane, const RoundBody& body)
      : p_SC(plane.R_WS.transpose() * (body.p_WC - plane.p_WS)),
        axis_S(plane.R_WS.transpose() * body.axis_W),
        sine(axis_S.head<2>().norm()) {}

  Vector3d end(const RoundBody& body, double side) const { return p_SC + side * body.half_length_m * axis_S; }
};

// The lateral surface. Its centre is where the axis meets the plane; where that is too far away, the point of
// the plane nearest to the body's centre.
void cut_side(const InSensorFrame& at, const RoundBody& body, int object, PlanarSlice& slice) {
  constexpr double kSteepAxis = 0.05;
  const Vector2d a = at.axis_S.head<2>();
  const double az = at.axis_S.z();
  const double cz = at.p_SC.z();
  if (std::abs(cz) > body.half_length_m * std::abs(az) + body.radius_m * at.sine) return;
  const bool steep = std::abs(az) > kSteepAxis;
  const double along_axis_m = steep ? -cz / az : -cz * az;  // of the centre of the arc
  const Vector2d center_m = at.p_SC.head<2>() + (steep ? along_axis_m : 0.0) * a;
  if (at.sine == 0.0) {
    slice.discs.push_back({center_m, body.radius_m, object});
    return;
  }
  SliceArc arc;
  arc.center_m = center_m;
  arc.form = Matrix2d::Identity() - a * a.transpose();
  arc.level = body.radius_m * body.radius_m;
  if (!steep) {
    arc.slope = cz * az * a;
    arc.level -= cz * cz * at.sine * at.sine;
  }
  arc.along = a;
  arc.from = -body.half_length_m - along_axis_m;
  arc.to = body.half_length_m - along_axis_m;
  arc.normal = body.radius_m;
  arc.object = object;
  slice.arcs.push_back(arc);
}

// A flat round end: the chord that the plane cuts out of it.
void cut_flat_end(const InSensorFrame& at, const RoundBody& body, double side, PlanarSlice& slice) {
  if (at.sine == 0.0) return;
  const Vector3d p_SE = at.end(body, side);
  // Within the end, the direction that rises fastest: it rises by `sine`.
  const Vector3d rising = (Vector3d::UnitZ() - at.axis_S.z() * at.axis_S) / at.sine;
  const double to_plane_m = -p_SE.z() / at.sine;
  const double half_chord_sq = body.radius_m * body.radius_m - to_plane_m * to_plane_m;
  if (half_chord_sq <= 0.0) return;
  const Vector2d level = at.axis_S.cross(rising).head<2>();
  const Vector2d middle_m = p_SE.head<2>() + to_plane_m * rising.head<2>();
  const Vector2d half_m = std::sqrt(half_chord_sq) * level;
  slice.segments.push_back({middle_m - half_m, middle_m + half_m, 0, at.sine});
}

// Of the ball about the end, what lies beyond the end.
void cut_round_end(const InSensorFrame& at, const RoundBody& body, double side, PlanarSlice& slice) {
  const Vector3d p_SE = at.end(body, side);
  const double level = body.radius_m * body.radius_m - p_SE.z() * p_SE.z();
  if (level <= 0.0) return;
  SliceArc arc;
  arc.center_m = p_SE.head<2>();
  arc.level = level;
  arc.along = side * at.axis_S.head<2>();
  arc.from = side * at.axis_S.z() * p_SE.z();
  arc.to = kInfinity;
  arc.normal = body.radius_m;
  slice.arcs.push_back(arc);
}

// A corner in the plane counts as above it, but those of a body that stands on the plane as below.
bool is_above(const Vector3d& p_SQ, double lowest_m) {
  return lowest_m < 0.0 ? p_SQ.z() >= 0.0 : p_SQ.z() > 0.0;
}

}  // namespace

Polyhedron prism(const std::vector<Vector2d>& outline_m, double bottom_m, double top_m,
                 const std::vector<int>& objects) {
  const int n = static_cast<int>(outline_m.size());
  SCANBED_ENSURE(n >= 3 && objects.size() == outline_m.size() + 1);
  Polyhedron body;
  for (const double z_m : {bottom_m, top_m}) {
    for (const Vector2d& p_WQ : outline_m) body.corners_m.emplace_back(p_WQ.x(), p_WQ.y(), z_m);
  }
  for (int i = 0; i < n; ++i) body.edges.push_back({i, (i + 1) % n});          // 0 .. n - 1: below
  for (int i = 0; i < n; ++i) body.edges.push_back({n + i, n + (i + 1) % n});  // n .. 2n - 1: above
  for (int i = 0; i < n; ++i) body.edges.push_back({i, n + i});                // 2n .. 3n - 1: upright
  std::vector<int> below;
  std::vector<int> above;
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    const Vector2d along = (outline_m[next] - outline_m[i]).normalized();
    body.faces.push_back({{i, 2 * n + next, n + i, 2 * n + i}, {along.y(), -along.x(), 0.0}, objects[i]});
    below.push_back(i);
    above.push_back(n + i);
  }
  body.faces.push_back({below, -Vector3d::UnitZ(), objects[n]});
  body.faces.push_back({above, Vector3d::UnitZ(), objects[n]});
  return body;
}

Polyhedron sheet(const std::array<Vector2d, 2>& line_m, double bottom_m, double top_m, int object) {
  const auto& [a, b] = line_m;
  const Vector2d along = (b - a).normalized();
  Polyhedron body;
  body.corners_m = {
      {a.x(), a.y(), bottom_m}, {b.x(), b.y(), bottom_m}, {b.x(), b.y(), top_m}, {a.x(), a.y(), top_m}};
  body.edges = {{0, 3}, {0, 1}, {1, 2}, {3, 2}};
  body.faces = {{{0, 1, 2, 3}, {along.y(), -along.x(), 0.0}, object}};
  return body;
}

void PlaneCutter::cut(const LaserPlane& plane, const Polyhedron& body, PlanarSlice& slice) {
  corners_S_.clear();
  double lowest_m = kInfinity;
  double highest_m = -kInfinity;
  for (const Vector3d& p_WQ : body.corners_m) {
    corners_S_.push_back(plane.R_WS.transpose() * (p_WQ - plane.p_WS));
    lowest_m = std::min(lowest_m, corners_S_.back().z());
    highest_m = std::max(highest_m, corners_S_.back().z());
  }
  if (lowest_m > 0.0 || highest_m < 0.0) return;
  crossings_.clear();
  for (const auto& [from, to] : body.edges) {
    const Vector3d& a = corners_S_[from];
    const Vector3d& b = corners_S_[to];
    Crossing& crossing = crossings_.emplace_back();
    crossing.crosses = is_above(a, lowest_m) != is_above(b, lowest_m);
    if (crossing.crosses) crossing.p_SQ = a.head<2>() + a.z() / (a.z() - b.z()) * (b.head<2>() - a.head<2>());
  }
  for (const Polyhedron::Face& face : body.faces) {
    std::array<Vector2d, 2> ends;
    std::size_t count = 0;
    for (const int edge : face.edges) {
      if (crossings_[edge].crosses && count < 2) ends[count++] = crossings_[edge].p_SQ;
    }
    if (count < 2) continue;
    const double out_of_plane = plane.R_WS.col(2).dot(face.normal_W);
    slice.segments.push_back(
        {ends[0], ends[1], face.object, std::sqrt(std::max(0.0, 1.0 - out_of_plane * out_of_plane))});
  }
}

void cut_cylinder(const LaserPlane& plane, const RoundBody& body, const CylinderObjects& objects,
                  PlanarSlice& slice) {
  const InSensorFrame at(plane, body);
  const std::size_t before = slice.segments.size();
  cut_flat_end(at, body, -1.0, slice);
  cut_flat_end(at, body, 1.0, slice);
  for (std::size_t i = before; i < slice.segments.size(); ++i) slice.segments[i].object = objects.ends;
  cut_side(at, body, objects.side, slice);
}

void cut_capsule(const LaserPlane& plane, const RoundBody& body, int object, PlanarSlice& slice) {
  const InSensorFrame at(plane, body);
  const std::size_t before = slice.arcs.size();
  cut_round_end(at, body, -1.0, slice);
  cut_round_end(at, body, 1.0, slice);
  for (std::size_t i = before; i < slice.arcs.size(); ++i) slice.arcs[i].object = object;
  cut_side(at, body, object, slice);
}

void cut_ellipsoid(const LaserPlane& plane, const Ellipsoid& body, int object, PlanarSlice& slice) {
  const Matrix3d R_SB = plane.R_WS.transpose() * body.R_WB;
  const Vector3d p_SC = plane.R_WS.transpose() * (body.p_WC - plane.p_WS);
  const double reach_m = R_SB.row(2).transpose().cwiseProduct(body.half_m).norm();
  if (std::abs(p_SC.z()) >= reach_m) return;
  const Matrix3d form =
      R_SB * body.half_m.cwiseProduct(body.half_m).cwiseInverse().asDiagonal() * R_SB.transpose();
  SliceArc arc;
  arc.center_m = p_SC.head<2>();
  arc.form = form.topLeftCorner<2, 2>();
  arc.slope = -p_SC.z() * form.col(2).head<2>();
  arc.level = 1.0 - p_SC.z() * p_SC.z() * form(2, 2);
  arc.object = object;
  slice.arcs.push_back(arc);
}

void cut_floor(const LaserPlane& plane, int object, PlanarSlice& slice) {
  const Vector3d up_S = plane.R_WS.row(2);
  const double slope = up_S.head<2>().norm();
  if (slope * kFloorReach_m < plane.p_WS.z()) return;  // as good as parallel
  const Vector2d downhill = -up_S.head<2>() / slope;
  const Vector2d nearest_m = plane.p_WS.z() / slope * downhill;
  const Vector2d half_m = kFloorReach_m * Vector2d(-downhill.y(), downhill.x());
  slice.segments.push_back({nearest_m - half_m, nearest_m + half_m, object, slope});
}

}  // namespace scanbed::sim
