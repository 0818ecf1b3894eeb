// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/planar/planar_slice.hpp"

namespace scanbed::sim {

/// A laser in space. Its beams lie in the plane of its x (forward) and y (left) axes; z is the plane's
/// normal.
struct LaserPlane {
  Eigen::Vector3d p_WS = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_WS = Eigen::Matrix3d::Identity();
};

/// A convex body, or a flat convex sheet, by its corners.
struct Polyhedron {
  struct Face {
    std::vector<int> edges;  ///< once round, indices into edges
    Eigen::Vector3d normal_W;
    int object = 0;
  };
  std::vector<Eigen::Vector3d> corners_m;  ///< p_WQ
  std::vector<std::array<int, 2>> edges;   ///< indices into corners_m; faces share them
  std::vector<Face> faces;
};

/// What stands upright over a convex outline; `objects` has one for each side (from corner i to i + 1), then
/// one for top and underside.
Polyhedron prism(const std::vector<Eigen::Vector2d>& outline_m, double bottom_m, double top_m,
                 const std::vector<int>& objects);

/// An upright rectangle without thickness over the line from a to b.
Polyhedron sheet(const std::array<Eigen::Vector2d, 2>& line_m, double bottom_m, double top_m, int object);

/// A cylinder, or a capsule (then the half length is without the round ends).
struct RoundBody {
  Eigen::Vector3d p_WC = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();  ///< of length 1
  double radius_m = 0.0;
  double half_length_m = 0.0;
};

struct Ellipsoid {
  Eigen::Vector3d p_WC = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
  Eigen::Vector3d half_m = Eigen::Vector3d::Ones();  ///< semi-axes
};

// Each appends to the slice where the plane cuts the body's surface, in the sensor frame: the frame L of such
// a slice is S. Exact to rounding: neighbouring faces of a polyhedron share their corner to the bit. A plane
// that merely touches a face may cut or miss it.
class PlaneCutter {
 public:
  void cut(const LaserPlane& plane, const Polyhedron& body, PlanarSlice& slice);

 private:
  struct Crossing {
    Eigen::Vector2d p_SQ = Eigen::Vector2d::Zero();
    bool crosses = false;
  };
  std::vector<Eigen::Vector3d> corners_S_;  // scratch, kept so that cutting allocates nothing
  std::vector<Crossing> crossings_;
};

/// What the parts of a cylinder's surface are.
struct CylinderObjects {
  int side = 0;
  int ends = 0;
};
void cut_cylinder(const LaserPlane& plane, const RoundBody& body, const CylinderObjects& objects,
                  PlanarSlice& slice);
void cut_capsule(const LaserPlane& plane, const RoundBody& body, int object, PlanarSlice& slice);
void cut_ellipsoid(const LaserPlane& plane, const Ellipsoid& body, int object, PlanarSlice& slice);

/// The floor at z = 0, without end: as one very long segment where the laser looks down.
void cut_floor(const LaserPlane& plane, int object, PlanarSlice& slice);

}  // namespace scanbed::sim
