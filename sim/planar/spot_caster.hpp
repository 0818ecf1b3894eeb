// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/scan/scan_geometry.hpp"
#include "sim/planar/arc_in_beams.hpp"
#include "sim/planar/planar_slice.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/sensor/ideal_returns.hpp"

namespace scanbed::sim {

/// The light spot of a beam: `num_rays` rays side by side, evenly over its diameter, the brightness of each
/// as of a Gaussian disc seen from the side (1 / e^2 at its rim).
struct Spot {
  double diameter_m = 0.0;      ///< at the sensor
  double divergence_rad = 0.0;  ///< full angle by which it widens
  int num_rays = 7;             ///< at most kMaxSpotRays

  double half_angle_rad(double range_m) const { return 0.5 * (diameter_m / range_m + divergence_rad); }
};

inline constexpr int kMaxSpotRays = 9;

/// Finds the beams whose spot has an edge in it, and casts the rays of those spots: on a smooth surface the
/// beam's axis says all.
///
/// An edge is an end of a segment or a tangent to a disc that no nearer surface hides. Where two surfaces run
/// through each other or touch, there is no step and no edge; their beams are not split.
///
/// @par Cost  O(shapes + split beams x rays x shapes that may meet them); no allocation in the steady state.
class SpotCaster {
 public:
  /// @pre as of RayCaster; 1 <= spot.num_rays <= kMaxSpotRays.
  SpotCaster(const ScanGeometry& geometry, BeamSubset subset, const Spot& spot);

  /// Makes room for slices of so many shapes, so that a cast allocates nothing.
  void reserve(std::size_t num_shapes) { shapes_.reserve(num_shapes); }

  /// Appends to `out` the spots that met more than one surface (or a surface and nothing), beams counted as
  /// the scan does.
  /// @param axes  what the axes of the same beams met, in the same slice from the same place.
  void cast(const PlanarSlice& slice, const Pose2& X_LS, const RayCaster& axes, IdealReturns& out);

 private:
  /// A segment or disc in the sensor frame.
  struct Shape {
    Eigen::Vector2d a_m;  ///< one end, or the centre
    Eigen::Vector2d b_m;  ///< the other end
    double radius_m;      ///< 0 for a segment
    double steepness;     ///< SliceSegment::steepness_ratio
    double from;          ///< of its right end, in beams
    double to;            ///< of its left end; not below from, perhaps beyond a turn
    double from_half;     ///< half of the spot at that end, in beams
    double to_half;
    int object;
    int arc = -1;  ///< index into arcs_, where it is one; a_m and b_m are where the tangents touch
  };
  struct Ray {
    Eigen::Vector2d p_SO;  ///< where it leaves the sensor
    Eigen::Vector2d u;
    double range_m;
    double cos_incidence;
    int object;
  };
  /// A place that a ray may start or end at.
  struct End {
    double at;       ///< in beams
    double half;     ///< of the spot, in beams
    double range_m;  ///< of the edge
  };

  void add_segment(const Eigen::Vector2d& p_SA, const Eigen::Vector2d& p_SB, const SliceSegment& segment);
  void add_disc(const Eigen::Vector2d& p_SC, const SliceDisc& disc);
  void add_arc(const SliceArc& arc, const Pose2& X_LS);
  void add(Shape shape, const Eigen::Vector2d& p_SR, const Eigen::Vector2d& p_SL);
  void mark(const End& end, const RayCaster& axes);
  bool is_hidden(int first, int last, double range_m, const RayCaster& axes) const;
  void lay_rays();
  void meet(const Shape& shape);
  void meet(const Shape& shape, Ray& ray) const;
  void meet_arc(const Shape& shape, Ray& ray) const;
  void hand_out(IdealReturns& out) const;

  BeamSubset subset_;
  Spot spot_;
  int num_beams_ = 0;
  double first_rad_;
  double steps_per_rad_;
  double steps_per_turn_;
  std::array<double, kMaxSpotRays> share_{};   ///< place over the spot's diameter, [-1, 1] from right to left
  std::array<double, kMaxSpotRays> weight_{};  ///< their sum is 1
  std::vector<Eigen::Vector2d> axis_;
  std::vector<Shape> shapes_;
  std::vector<ArcInBeams> arcs_;
  std::vector<char> is_marked_;  ///< by beam of the subset
  std::vector<int> marked_;      ///< those beams, rising
  std::vector<int> rank_;        ///< by beam and one more: how many marked beams come before
  std::vector<Ray> rays_;        ///< of the marked beams
};

}  // namespace scanbed::sim
