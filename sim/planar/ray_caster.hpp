// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/scan/scan_geometry.hpp"
#include "sim/planar/arc_in_beams.hpp"
#include "sim/planar/planar_slice.hpp"

namespace scanbed::sim {

/// Which beams of a scan a caster casts: first, first + stride, ... as far as there are. An interlaced scan
/// is cast rotation by rotation, each at its own time.
struct BeamSubset {
  int first = 0;
  int stride = 1;
  int count = std::numeric_limits<int>::max();  ///< at most so many
};

/// Ideal returns of a planar scan: for each beam the first surface that it meets.
///
/// An angular z-buffer: each shape is projected onto the beams that it can cover, and the nearest return
/// wins. It is kept as 1 / range, which along a straight wall is linear in the beam's direction. Exact to
/// rounding: which beams meet a wall is decided by the signs of cross products that walls with a common
/// corner share to the bit, so no beam slips through between them.
///
/// A surface is met from both sides; a sensor in a disc sees it from inside. A sensor on a wall meets it at
/// range 0 in all directions; a wall seen along its length or of length 0 is not met.
///
/// @par Cost  O(beams + shapes + beams covered by each shape); no allocation but by the largest slice so far.
class RayCaster {
 public:
  /// @pre geometry.step_rad > 0, the beams go round at most once; the subset is not negative, its stride > 0.
  explicit RayCaster(const ScanGeometry& geometry, BeamSubset subset = {});

  /// Makes room for slices of so many shapes, so that a cast allocates nothing.
  void reserve(std::size_t num_shapes) { shapes_.reserve(num_shapes); }

  /// Casts all beams of the subset from a sensor at X_LS in the frame of the slice.
  void cast(const PlanarSlice& slice, const Pose2& X_LS);

  // The i-th beam of the subset, in the last cast.
  int num_beams() const { return static_cast<int>(range_m_.size()); }
  int scan_beam(int i) const { return subset_.first + i * subset_.stride; }  ///< its number in the scan
  double range_m(int i) const { return range_m_[i]; }                        ///< kNoEcho where it met nothing
  int object(int i) const;            ///< of the surface; kNoObject where it met nothing
  double incidence_rad(int i) const;  ///< between beam and surface normal, [0, pi/2]; 0 where it met nothing

  double cos_incidence(int i) const;  ///< of that angle; 1 where it met nothing

  const std::vector<double>& ranges_m() const { return range_m_; }

 private:
  /// A shape in the sensor frame, as far as a beam's incidence needs it.
  struct Shape {
    Eigen::Vector2d center_m;  ///< p_SC of a disc
    double size_m;             ///< disc: radius; wall: distance of its line from the sensor
    int object;
    bool is_disc;
    double steepness_ratio;
    int arc = -1;  ///< index into arcs_, where it is one
  };
  /// Beams that a shape may cover, both ends included, and those in the middle that it surely covers.
  struct Span {
    int first, last;
    int sure_first, sure_last;
  };
  struct Spans {
    std::array<Span, 3> span;
    int count = 0;
  };

  void cast_segment(const Eigen::Vector2d& p_SA, const Eigen::Vector2d& p_SB, double shape);
  void cast_from_inside_wall(double shape);
  void cast_disc(const Eigen::Vector2d& p_SC, double radius_m, double shape);
  void cast_from_inside_disc(const Eigen::Vector2d& p_SC, double radius_m, double shape);
  void cast_arc(const ArcInBeams& arc, double shape);
  Spans spans_between(const Eigen::Vector2d& p_SR, const Eigen::Vector2d& p_SL) const;

  BeamSubset subset_;
  double first_rad_;
  double steps_per_rad_;
  double steps_per_turn_;
  int margin_;                   ///< beams at either end of a span that the coarse bearings leave in doubt
  std::vector<double> ux_, uy_;  ///< directions
  std::vector<double> inverse_range_;  ///< 1 / metres; 0 where nothing was met
  std::vector<double> winner_;         ///< index into shapes_, as a double so that loops vectorise; or -1
  std::vector<double> range_m_;
  std::vector<Shape> shapes_;
  std::vector<ArcInBeams> arcs_;
};

}  // namespace scanbed::sim
