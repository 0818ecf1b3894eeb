// SPDX-License-Identifier: MIT
#include "sim/planar/spot_caster.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/errors/ensure.hpp"
#include "core/geometry/cross.hpp"
#include "core/scan/laser_scan.hpp"
#include "sim/planar/coarse_atan2.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kMaxHalfSpot_rad = 0.5;  // closer to the window than its width an edge fills the view anyway

}  // namespace

SpotCaster::SpotCaster(const ScanGeometry& geometry, BeamSubset subset, const Spot& spot)
    : subset_(subset),
      spot_(spot),
      first_rad_(geometry.bearing_rad(subset.first)),
      steps_per_rad_(1.0 / (geometry.step_rad * subset.stride)),
      steps_per_turn_(2.0 * kPi * steps_per_rad_) {
  SCANBED_ENSURE(spot.num_rays >= 1 && spot.num_rays <= kMaxSpotRays);
  for (int beam = subset.first; beam < geometry.num_beams && num_beams_ < subset.count;
       beam += subset.stride) {
    axis_.emplace_back(std::cos(geometry.bearing_rad(beam)), std::sin(geometry.bearing_rad(beam)));
    ++num_beams_;
  }
  double sum = 0.0;
  for (int k = 0; k < spot.num_rays; ++k) {
    share_[k] = spot.num_rays == 1 ? 0.0 : 2.0 * k / (spot.num_rays - 1) - 1.0;
    weight_[k] = std::exp(-2.0 * share_[k] * share_[k]);
    sum += weight_[k];
  }
  for (int k = 0; k < spot.num_rays; ++k) weight_[k] /= sum;
  is_marked_.resize(num_beams_);
  rank_.resize(num_beams_ + 1);
  marked_.reserve(num_beams_);
  rays_.reserve(static_cast<std::size_t>(num_beams_) * spot.num_rays);
}

void SpotCaster::cast(const PlanarSlice& slice, const Pose2& X_LS, const RayCaster& axes, IdealReturns& out) {
  shapes_.clear();
  arcs_.clear();
  const Vector2d x_axis = X_LS.heading();
  const Vector2d y_axis(-x_axis.y(), x_axis.x());
  const auto to_sensor = [&](const Vector2d& p_LQ) {
    const Vector2d p_SQ_L = p_LQ - X_LS.p_m;
    return Vector2d(x_axis.dot(p_SQ_L), y_axis.dot(p_SQ_L));
  };
  for (const SliceSegment& s : slice.segments) add_segment(to_sensor(s.a_m), to_sensor(s.b_m), s);
  for (const SliceDisc& d : slice.discs) add_disc(to_sensor(d.center_m), d);
  for (const SliceArc& a : slice.arcs) add_arc(a, X_LS);
  std::fill(is_marked_.begin(), is_marked_.end(), char{0});
  for (const Shape& shape : shapes_) {
    const bool is_disc = shape.radius_m > 0.0;
    const double tangent_m =
        is_disc ? std::sqrt(shape.a_m.squaredNorm() - shape.radius_m * shape.radius_m) : 0.0;
    mark({shape.from, shape.from_half, is_disc ? tangent_m : shape.a_m.norm()}, axes);
    mark({shape.to, shape.to_half, is_disc ? tangent_m : shape.b_m.norm()}, axes);
  }
  lay_rays();
  for (const Shape& shape : shapes_) meet(shape);
  hand_out(out);
}

void SpotCaster::add_segment(const Vector2d& p_SA, const Vector2d& p_SB, const SliceSegment& segment) {
  const double area_m2 = cross(p_SA, p_SB);
  if (area_m2 == 0.0) return;  // seen along its length, or the sensor is on it
  const bool a_is_right = area_m2 > 0.0;
  const Vector2d& p_SR = a_is_right ? p_SA : p_SB;
  const Vector2d& p_SL = a_is_right ? p_SB : p_SA;
  add({p_SR, p_SL, 0.0, segment.steepness_ratio, 0.0, 0.0, 0.0, 0.0, segment.object}, p_SR, p_SL);
}

void SpotCaster::add_disc(const Vector2d& p_SC, const SliceDisc& disc) {
  const double radius_m = disc.radius_m;
  const double tangent_sq_m2 = p_SC.squaredNorm() - radius_m * radius_m;
  if (tangent_sq_m2 <= 0.0) return;  // from inside there is no edge
  const double cosine = std::sqrt(tangent_sq_m2 / p_SC.squaredNorm());
  const Vector2d along = cosine * cosine * p_SC;
  const Vector2d across = cosine * radius_m / p_SC.norm() * Vector2d(-p_SC.y(), p_SC.x());
  add({p_SC, p_SC, radius_m, disc.steepness_ratio, 0.0, 0.0, 0.0, 0.0, disc.object}, along - across,
      along + across);
}

// What cannot be said to lie between two tangents may be anywhere, and has no edge that could be found.
void SpotCaster::add_arc(const SliceArc& given, const Pose2& X_LS) {
  const ArcInBeams arc(given, X_LS);
  const int index = static_cast<int>(arcs_.size());
  arcs_.push_back(arc);
  const std::optional<ArcInBeams::Wedge> wedge = arc.wedge();
  if (!wedge) {
    shapes_.push_back(
        {Vector2d::Zero(), Vector2d::Zero(), 0.0, 1.0, 0.0, num_beams_ - 1.0, 0.0, 0.0, given.object, index});
    return;
  }
  const Vector2d p_SR = arc.touch_m(wedge->right);
  const Vector2d p_SL = arc.touch_m(wedge->left);
  add({p_SR, p_SL, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, given.object, index}, p_SR, p_SL);
}

void SpotCaster::add(Shape shape, const Vector2d& p_SR, const Vector2d& p_SL) {
  const double right_rad = coarse_atan2(p_SR.y(), p_SR.x());
  double width_rad = coarse_atan2(p_SL.y(), p_SL.x()) - right_rad;
  if (width_rad < 0.0) width_rad += 2.0 * kPi;
  if (width_rad > 1.5 * kPi) width_rad = 0.0;  // a sliver, its ends exchanged by the coarse bearings
  const auto half_of = [&](const Vector2d& end) {
    const double half_rad = std::min(spot_.half_angle_rad(end.norm()), kMaxHalfSpot_rad);
    return (half_rad + 2.0 * kCoarseAtan2Error_rad) * steps_per_rad_;
  };
  shape.from = (right_rad - first_rad_) * steps_per_rad_;
  shape.to = shape.from + width_rad * steps_per_rad_;
  shape.from_half = half_of(p_SR);
  shape.to_half = half_of(p_SL);
  shapes_.push_back(shape);
}

void SpotCaster::mark(const End& end, const RayCaster& axes) {
  for (int turn = -1; turn <= 1; ++turn) {
    const double at = end.at + turn * steps_per_turn_;
    if (at + end.half < 0.0 || at - end.half > num_beams_ - 1) continue;
    const int first = static_cast<int>(std::max(std::ceil(at - end.half), 0.0));
    const int last = static_cast<int>(std::min(std::floor(at + end.half), num_beams_ - 1.0));
    if (first > last || is_hidden(first, last, end.range_m, axes)) continue;
    std::fill(is_marked_.begin() + first, is_marked_.begin() + last + 1, char{1});
  }
}

// One nearer surface from a beam before to a beam behind.
bool SpotCaster::is_hidden(int first, int last, double range_m, const RayCaster& axes) const {
  const int before = std::max(first - 1, 0);
  const int behind = std::min(last + 1, num_beams_ - 1);
  const int object = axes.object(before);
  if (before == first || behind == last || object == kNoObject) return false;
  for (int i = before; i <= behind; ++i) {
    if (axes.object(i) != object || axes.range_m(i) > range_m * (1.0 - 1e-9)) return false;
  }
  return true;
}

void SpotCaster::lay_rays() {
  marked_.clear();
  rays_.clear();
  for (int i = 0; i < num_beams_; ++i) {
    rank_[i] = static_cast<int>(marked_.size());
    if (is_marked_[i] == 0) continue;
    marked_.push_back(i);
    const Vector2d& u = axis_[i];
    const Vector2d left(-u.y(), u.x());
    for (int k = 0; k < spot_.num_rays; ++k) {
      // The angle is a few thousandths: its cosine and sine to the fourth order are exact to rounding.
      const double a = 0.5 * share_[k] * spot_.divergence_rad;
      const double a2 = a * a;
      rays_.push_back({0.5 * share_[k] * spot_.diameter_m * left,
                       (1.0 - a2 / 2 * (1.0 - a2 / 12)) * u + a * (1.0 - a2 / 6 * (1.0 - a2 / 20)) * left,
                       kNoEcho, 1.0, kNoObject});
    }
  }
  rank_[num_beams_] = static_cast<int>(marked_.size());
}

void SpotCaster::meet(const Shape& shape) {
  for (int turn = -1; turn <= 1; ++turn) {
    const double from = shape.from - shape.from_half + turn * steps_per_turn_;
    const double to = shape.to + shape.to_half + turn * steps_per_turn_;
    if (to < 0.0 || from > num_beams_ - 1) continue;
    const int first = static_cast<int>(std::max(std::ceil(from), 0.0));
    const int last = static_cast<int>(std::min(std::floor(to), num_beams_ - 1.0));
    if (first > last) continue;
    const int behind = rank_[last + 1] * spot_.num_rays;
    for (int i = rank_[first] * spot_.num_rays; i < behind; ++i) meet(shape, rays_[i]);
  }
}

void SpotCaster::meet_arc(const Shape& shape, Ray& ray) const {
  const ArcInBeams arc = arcs_[shape.arc].seen_from(ray.p_SO);
  const double inverse_range = arc.inverse_range(ray.u);
  if (inverse_range * ray.range_m <= 1.0) return;
  ray.range_m = 1.0 / inverse_range;
  ray.cos_incidence = arc.cos_incidence(ray.u, inverse_range);
  ray.object = shape.object;
}

void SpotCaster::meet(const Shape& shape, Ray& ray) const {
  if (shape.arc >= 0) {
    meet_arc(shape, ray);
    return;
  }
  const Vector2d p_OA = shape.a_m - ray.p_SO;
  double range_m = kNoEcho;
  double cosine = 1.0;
  if (shape.radius_m > 0.0) {
    const double beside_m = cross(p_OA, ray.u);
    const double half_chord_sq = shape.radius_m * shape.radius_m - beside_m * beside_m;
    if (half_chord_sq < 0.0) return;
    const double half_chord_m = std::sqrt(half_chord_sq);
    range_m = p_OA.dot(ray.u) - half_chord_m;
    cosine = half_chord_m / shape.radius_m;
  } else {
    const Vector2d p_OB = shape.b_m - ray.p_SO;
    if (cross(p_OA, ray.u) * cross(p_OB, ray.u) > 0.0) return;
    const Vector2d along = p_OB - p_OA;
    const double slant_m = cross(ray.u, along);
    if (slant_m == 0.0) return;
    range_m = cross(p_OA, along) / slant_m;
    if (range_m < ray.range_m) cosine = std::abs(slant_m) / along.norm();
  }
  if (range_m <= 0.0 || range_m >= ray.range_m) return;
  ray.range_m = range_m;
  ray.cos_incidence = shape.steepness * cosine;
  ray.object = shape.object;
}

void SpotCaster::hand_out(IdealReturns& out) const {
  const int n = spot_.num_rays;
  for (std::size_t m = 0; m < marked_.size(); ++m) {
    const Ray* rays = rays_.data() + m * n;
    if (std::all_of(rays, rays + n, [&](const Ray& r) { return r.object == rays[0].object; })) continue;
    const int beam = subset_.first + marked_[m] * subset_.stride;
    out.split_spots.push_back({beam, static_cast<int>(out.spot_returns.size()), n});
    for (int k = 0; k < n; ++k) {
      out.spot_returns.push_back({weight_[k], rays[k].range_m, rays[k].cos_incidence, rays[k].object});
    }
  }
}

}  // namespace scanbed::sim
