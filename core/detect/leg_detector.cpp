// SPDX-License-Identifier: MIT
#include "core/detect/leg_detector.hpp"

#include <cmath>

#include "core/detect/chord.hpp"

namespace scanbed {
namespace {

bool hides(const LaserScan& scan, int neighbour, int end) {
  const bool full_circle = std::abs(scan.geometry.step_rad) * scan.num_beams() >= 2.0 * kPi - 1e-6;
  const int num_beams = scan.num_beams();
  if (neighbour < 0 || neighbour >= num_beams) {
    if (!full_circle) return true;
    neighbour = (neighbour + num_beams) % num_beams;
  }
  // No echo is +inf and so farther, too close is -inf and so nearer; NaN says nothing and hides nothing.
  return scan.range_m[neighbour] < scan.range_m[end];
}

}  // namespace

bool is_partly_occluded(const LaserScan& scan, const Points& points, const Segment& segment) {
  const int first = points.beam[segment.first];
  const int last = points.beam[segment.last];
  return hides(scan, first - 1, first) || hides(scan, last + 1, last);
}

std::optional<Leg> detect_leg(const LaserScan& scan, const Points& points, const Segment& segment,
                              const LegOptions& options) {
  if (!options.enabled || segment.num_points() < options.min_points) return std::nullopt;
  const double width_m = (points[segment.last] - points[segment.first]).norm();
  if (width_m < options.min_width_m || width_m > options.max_width_m) return std::nullopt;
  if (!bulges_like_an_arc(points, segment, options.min_depth_ratio, options.max_depth_ratio)) {
    return std::nullopt;
  }
  if (is_partly_occluded(scan, points, segment)) return std::nullopt;

  Leg leg;
  leg.beams = {points.beam[segment.first], points.beam[segment.last]};
  // Of an even number the middle lies between two, so that a mirrored scan has a mirrored leg.
  leg.middle_m =
      0.5 * (points[(segment.first + segment.last) / 2] + points[(segment.first + segment.last + 1) / 2]);
  // The paper gives no measure: more points say more, and a width in the middle of the band fits more legs.
  const double middle_m = (options.min_width_m + options.max_width_m) / 2;
  const double off_ratio = std::abs(width_m - middle_m) / (options.max_width_m - options.min_width_m);
  leg.score = (1.0 - 1.0 / segment.num_points()) * (1.0 - 0.5 * off_ratio);
  return leg;
}

void append_by_score(const Leg& leg, const LegOptions& options, Features& features) {
  if (leg.score >= options.min_score) {
    features.legs.push_back(leg);
  } else if (leg.score >= options.min_doubtful_score) {
    features.doubtful_legs.push_back(leg);
  }
}

}  // namespace scanbed
