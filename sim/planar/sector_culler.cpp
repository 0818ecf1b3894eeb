// SPDX-License-Identifier: MIT
#include "sim/planar/sector_culler.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/geometry/cross.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kRoundingRatio = 1e-9;  // of a place's distance
constexpr double kWidest_rad = kPi - 1e-3;

Vector2d direction(double bearing_rad) {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

}  // namespace

SectorCuller::SectorCuller(const ScanGeometry& geometry, BeamSubset subset, const Spot& spot)
    : half_spot_m_(0.5 * spot.diameter_m), spot_ratio_(spot.divergence_rad + kRoundingRatio) {
  const int num_beams =
      std::min(subset.count, (geometry.num_beams - subset.first + subset.stride - 1) / subset.stride);
  const int last = subset.first + std::max(num_beams - 1, 0) * subset.stride;
  is_all_ = geometry.bearing_rad(last) - geometry.bearing_rad(subset.first) > kWidest_rad;
  right_ = direction(geometry.bearing_rad(subset.first));
  left_ = direction(geometry.bearing_rad(last));
}

// How far a place lies beyond the spots of a beam is concave along a straight line: what both ends of a wall
// are out of, all of it is.
const PlanarSlice& SectorCuller::cull(const PlanarSlice& slice, const Pose2& X_LS) {
  if (is_all_) return slice;
  const Vector2d x_axis = X_LS.heading();
  const auto turned = [&](const Vector2d& u) {
    return Vector2d(x_axis.x() * u.x() - x_axis.y() * u.y(), x_axis.y() * u.x() + x_axis.x() * u.y());
  };
  const Vector2d right = turned(right_);
  const Vector2d left = turned(left_);
  const auto spot_m = [&](const Vector2d& p) { return half_spot_m_ + spot_ratio_ * p.cwiseAbs().sum(); };
  // For the whole slice, so that a sector into which things move later allocates nothing then.
  rest_.segments.reserve(slice.segments.size());
  rest_.discs.reserve(slice.discs.size());
  rest_.segments.clear();
  std::copy_if(slice.segments.begin(), slice.segments.end(), std::back_inserter(rest_.segments),
               [&](const SliceSegment& s) {
                 const Vector2d a = s.a_m - X_LS.p_m;
                 const Vector2d b = s.b_m - X_LS.p_m;
                 const double a_m = spot_m(a);
                 const double b_m = spot_m(b);
                 const bool is_right = cross(a, right) > a_m && cross(b, right) > b_m;
                 const bool is_left = cross(left, a) > a_m && cross(left, b) > b_m;
                 return !is_right && !is_left;
               });
  rest_.discs.clear();
  std::copy_if(slice.discs.begin(), slice.discs.end(), std::back_inserter(rest_.discs),
               [&](const SliceDisc& d) {
                 const Vector2d c = d.center_m - X_LS.p_m;
                 // The spot at the disc's farthest point is no larger than this.
                 const double reach_m = d.radius_m + spot_m(c) + 2.0 * spot_ratio_ * d.radius_m;
                 return cross(c, right) <= reach_m && cross(left, c) <= reach_m;
               });
  rest_.arcs.assign(slice.arcs.begin(), slice.arcs.end());
  return rest_;
}

}  // namespace scanbed::sim
