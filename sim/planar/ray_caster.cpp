// SPDX-License-Identifier: MIT
#include "sim/planar/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/errors/ensure.hpp"
#include "core/geometry/cross.hpp"
#include "core/scan/truth.hpp"
#include "sim/planar/coarse_atan2.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kNobody = -1.0;
constexpr double kOnSurface = std::numeric_limits<double>::infinity();  // 1 / range

/// The z-buffer, as plain pointers that do not overlap.
struct Beams {
  const double* __restrict ux;
  const double* __restrict uy;
  double* __restrict inverse_range;
  double* __restrict winner;
};

/// Neighbouring beams, both ends included; none where last < first.
struct BeamRun {
  int first;
  int last;
};

inline void keep_nearer(const Beams& beams, int i, double inverse_range, double shape) {
  const bool nearer = inverse_range > beams.inverse_range[i];
  beams.inverse_range[i] = nearer ? inverse_range : beams.inverse_range[i];
  beams.winner[i] = nearer ? shape : beams.winner[i];
}

// Beams each known to meet the line within the wall: 1 / range = m . u.
void cover(const Beams& beams, BeamRun run, const Vector2d& m, double shape) {
  const double mx = m.x();
  const double my = m.y();
  for (int i = run.first; i <= run.last; ++i)
    keep_nearer(beams, i, mx * beams.ux[i] + my * beams.uy[i], shape);
}

/// A wall in the sensor frame with its ends to the right and to the left.
struct Wall {
  Vector2d p_SR;
  Vector2d p_SL;
  Vector2d m;
};

// Beams of which only those between the wall's ends meet it.
void cover_ends(const Beams& beams, BeamRun run, const Wall& wall, double shape) {
  for (int i = run.first; i <= run.last; ++i) {
    const double left_of_right = wall.p_SR.x() * beams.uy[i] - wall.p_SR.y() * beams.ux[i];
    const double right_of_left = beams.ux[i] * wall.p_SL.y() - beams.uy[i] * wall.p_SL.x();
    if (left_of_right < 0.0 || right_of_left < 0.0) continue;
    keep_nearer(beams, i, wall.m.x() * beams.ux[i] + wall.m.y() * beams.uy[i], shape);
  }
}

/// A disc in the sensor frame, the sensor outside.
struct OutsideDisc {
  Vector2d p_SC;
  double radius_sq_m2;
  double scale_per_m2;  ///< 1 / (|p_SC|^2 - r^2)
};

// With b = c.u and h^2 = r^2 - (c x u)^2 the range is b - h, and (b - h)(b + h) = |c|^2 - r^2.
void cover_disc(const Beams& beams, BeamRun run, const OutsideDisc& disc, double shape) {
  const double cx = disc.p_SC.x();
  const double cy = disc.p_SC.y();
  for (int i = run.first; i <= run.last; ++i) {
    const double beside = cx * beams.uy[i] - cy * beams.ux[i];
    const double half_chord_sq = disc.radius_sq_m2 - beside * beside;
    const double b = cx * beams.ux[i] + cy * beams.uy[i];
    // Without a chord the square root is NaN, and nothing is nearer than NaN.
    keep_nearer(beams, i, (b + std::sqrt(half_chord_sq)) * disc.scale_per_m2, shape);
  }
}

}  // namespace

RayCaster::RayCaster(const ScanGeometry& geometry, BeamSubset subset)
    : subset_(subset),
      first_rad_(geometry.bearing_rad(subset.first)),
      steps_per_rad_(1.0 / (geometry.step_rad * subset.stride)),
      steps_per_turn_(2.0 * kPi * steps_per_rad_),
      margin_(1 + static_cast<int>(2.0 * kCoarseAtan2Error_rad * steps_per_rad_)) {
  SCANBED_ENSURE(geometry.step_rad > 0.0 && subset.first >= 0 && subset.stride > 0);
  SCANBED_ENSURE((geometry.num_beams - 1) * geometry.step_rad <= 2.0 * kPi + 1e-9);
  for (int beam = subset.first; beam < geometry.num_beams && static_cast<int>(ux_.size()) < subset.count;
       beam += subset.stride) {
    ux_.push_back(std::cos(geometry.bearing_rad(beam)));
    uy_.push_back(std::sin(geometry.bearing_rad(beam)));
  }
  inverse_range_.resize(ux_.size());
  winner_.resize(ux_.size(), kNobody);
  range_m_.resize(ux_.size(), std::numeric_limits<double>::infinity());
}

void RayCaster::cast(const PlanarSlice& slice, const Pose2& X_LS) {
  std::fill(inverse_range_.begin(), inverse_range_.end(), 0.0);
  std::fill(winner_.begin(), winner_.end(), kNobody);
  shapes_.clear();
  arcs_.clear();
  const Vector2d x_axis = X_LS.heading();
  const Vector2d y_axis(-x_axis.y(), x_axis.x());
  const auto to_sensor = [&](const Vector2d& p_LQ) {
    const Vector2d p_SQ_L = p_LQ - X_LS.p_m;
    return Vector2d(x_axis.dot(p_SQ_L), y_axis.dot(p_SQ_L));
  };
  for (const SliceSegment& segment : slice.segments) {
    const auto shape = static_cast<double>(shapes_.size());
    shapes_.push_back({Vector2d::Zero(), 0.0, segment.object, false, segment.steepness_ratio});
    cast_segment(to_sensor(segment.a_m), to_sensor(segment.b_m), shape);
  }
  for (const SliceDisc& disc : slice.discs) {
    const auto shape = static_cast<double>(shapes_.size());
    const Vector2d p_SC = to_sensor(disc.center_m);
    shapes_.push_back({p_SC, disc.radius_m, disc.object, true, disc.steepness_ratio});
    cast_disc(p_SC, disc.radius_m, shape);
  }
  for (const SliceArc& arc : slice.arcs) {
    const auto shape = static_cast<double>(shapes_.size());
    shapes_.push_back({Vector2d::Zero(), 0.0, arc.object, true, 1.0, static_cast<int>(arcs_.size())});
    arcs_.emplace_back(arc, X_LS);
    cast_arc(arcs_.back(), shape);
  }
  for (std::size_t i = 0; i < range_m_.size(); ++i) range_m_[i] = 1.0 / inverse_range_[i];
}

// The ends may lie up to half a turn apart, counter-clockwise from right to left. Their bearings are coarse:
// the spans are wider by margin_ beams, and surely covered is only what is as much narrower.
RayCaster::Spans RayCaster::spans_between(const Vector2d& p_SR, const Vector2d& p_SL) const {
  const double right_rad = coarse_atan2(p_SR.y(), p_SR.x());
  double width_rad = coarse_atan2(p_SL.y(), p_SL.x()) - right_rad;
  if (width_rad < 0.0) width_rad += 2.0 * kPi;
  if (width_rad > 1.5 * kPi) width_rad = 0.0;  // a sliver, its ends exchanged by the coarse bearings
  const double from = (right_rad - first_rad_) * steps_per_rad_;
  const double to = from + width_rad * steps_per_rad_;
  const int num_beams = static_cast<int>(ux_.size());
  Spans spans;
  for (int turn = -1; turn <= 1; ++turn) {
    const double shifted_from = from + turn * steps_per_turn_;
    const double shifted_to = to + turn * steps_per_turn_;
    if (shifted_to < -margin_ - 1 || shifted_from > num_beams + margin_) continue;
    const int lower =
        static_cast<int>(shifted_from);  // rounded towards 0: where that matters, beam 0 is near
    const int upper = static_cast<int>(shifted_to);
    Span& span = spans.span[spans.count++];
    span.first = std::max(lower - margin_, 0);
    span.last = std::min(upper + 1 + margin_, num_beams - 1);
    span.sure_first = std::max(lower + 1 + margin_, span.first);
    span.sure_last = std::min(upper - margin_, span.last);
  }
  return spans;
}

void RayCaster::cast_segment(const Vector2d& p_SA, const Vector2d& p_SB, double shape) {
  const double area_m2 = cross(p_SA, p_SB);
  if (area_m2 == 0.0) {
    if (p_SA != p_SB && p_SA.dot(p_SB) <= 0.0) cast_from_inside_wall(shape);
    return;
  }
  const bool a_is_right = area_m2 > 0.0;
  const Vector2d& p_SR = a_is_right ? p_SA : p_SB;
  const Vector2d& p_SL = a_is_right ? p_SB : p_SA;
  const Vector2d along = p_SL - p_SR;
  const double inverse_area = 1.0 / std::abs(area_m2);
  const Wall wall{p_SR, p_SL, Vector2d(along.y(), -along.x()) * inverse_area};
  shapes_.back().size_m = std::abs(area_m2) / along.norm();
  const Beams beams{ux_.data(), uy_.data(), inverse_range_.data(), winner_.data()};
  const Spans spans = spans_between(p_SR, p_SL);
  for (int k = 0; k < spans.count; ++k) {
    const Span& span = spans.span[k];
    if (span.sure_first > span.sure_last) {
      cover_ends(beams, {span.first, span.last}, wall, shape);
      continue;
    }
    cover_ends(beams, {span.first, span.sure_first - 1}, wall, shape);
    cover(beams, {span.sure_first, span.sure_last}, wall.m, shape);
    cover_ends(beams, {span.sure_last + 1, span.last}, wall, shape);
  }
}

void RayCaster::cast_from_inside_wall(double shape) {
  const Beams beams{ux_.data(), uy_.data(), inverse_range_.data(), winner_.data()};
  for (int i = 0; i < num_beams(); ++i) keep_nearer(beams, i, kOnSurface, shape);
}

void RayCaster::cast_disc(const Vector2d& p_SC, double radius_m, double shape) {
  const double tangent_sq_m2 = p_SC.squaredNorm() - radius_m * radius_m;
  if (tangent_sq_m2 <= 0.0) {
    cast_from_inside_disc(p_SC, radius_m, shape);
    return;
  }
  const double tangent_m = std::sqrt(tangent_sq_m2);
  const Vector2d across = radius_m * Vector2d(-p_SC.y(), p_SC.x());
  const Beams beams{ux_.data(), uy_.data(), inverse_range_.data(), winner_.data()};
  const Spans spans = spans_between(tangent_m * p_SC - across, tangent_m * p_SC + across);
  const OutsideDisc disc{p_SC, radius_m * radius_m, 1.0 / tangent_sq_m2};
  for (int k = 0; k < spans.count; ++k)
    cover_disc(beams, {spans.span[k].first, spans.span[k].last}, disc, shape);
}

void RayCaster::cast_from_inside_disc(const Vector2d& p_SC, double radius_m, double shape) {
  const Beams beams{ux_.data(), uy_.data(), inverse_range_.data(), winner_.data()};
  for (int i = 0; i < num_beams(); ++i) {
    const Vector2d u(ux_[i], uy_[i]);
    const double beside_m = cross(p_SC, u);
    const double half_chord_m = std::sqrt(std::max(0.0, radius_m * radius_m - beside_m * beside_m));
    keep_nearer(beams, i, 1.0 / std::max(0.0, p_SC.dot(u) + half_chord_m), shape);
  }
}

void RayCaster::cast_arc(const ArcInBeams& arc, double shape) {
  const Beams beams{ux_.data(), uy_.data(), inverse_range_.data(), winner_.data()};
  const auto cover_run = [&](BeamRun run) {
    for (int i = run.first; i <= run.last; ++i) {
      keep_nearer(beams, i, arc.inverse_range({ux_[i], uy_[i]}), shape);
    }
  };
  const std::optional<ArcInBeams::Wedge> wedge = arc.wedge();
  if (!wedge) {
    cover_run({0, num_beams() - 1});
    return;
  }
  const Spans spans = spans_between(wedge->right, wedge->left);
  for (int k = 0; k < spans.count; ++k) cover_run({spans.span[k].first, spans.span[k].last});
}

int RayCaster::object(int i) const {
  return winner_[i] == kNobody ? kNoObject : shapes_[static_cast<std::size_t>(winner_[i])].object;
}

double RayCaster::incidence_rad(int i) const {
  if (winner_[i] == kNobody) return 0.0;
  const Shape& shape = shapes_[static_cast<std::size_t>(winner_[i])];
  if (!shape.is_disc) {
    // A wall that the sensor stands on has no direction left to look at it from.
    if (range_m_[i] == 0.0) return 0.0;
    return std::acos(std::min(1.0, shape.steepness_ratio * shape.size_m * inverse_range_[i]));
  }
  if (shape.arc >= 0) {
    return std::acos(arcs_[shape.arc].cos_incidence({ux_[i], uy_[i]}, inverse_range_[i]));
  }
  const double sine = std::abs(cross(shape.center_m, Vector2d(ux_[i], uy_[i]))) / shape.size_m;
  if (shape.steepness_ratio == 1.0) return std::asin(std::min(1.0, sine));
  return std::acos(shape.steepness_ratio * std::sqrt(std::max(0.0, 1.0 - sine * sine)));
}

double RayCaster::cos_incidence(int i) const {
  if (winner_[i] == kNobody) return 1.0;
  const Shape& shape = shapes_[static_cast<std::size_t>(winner_[i])];
  if (!shape.is_disc) {
    if (range_m_[i] == 0.0) return 1.0;
    return std::min(1.0, shape.steepness_ratio * shape.size_m * inverse_range_[i]);
  }
  if (shape.arc >= 0) return arcs_[shape.arc].cos_incidence({ux_[i], uy_[i]}, inverse_range_[i]);
  const double sine = cross(shape.center_m, Vector2d(ux_[i], uy_[i])) / shape.size_m;
  return shape.steepness_ratio * std::sqrt(std::max(0.0, 1.0 - sine * sine));
}

}  // namespace scanbed::sim
