// SPDX-License-Identifier: MIT
#include "core/detect/circle_detector.hpp"

#include <cmath>
#include <limits>

#include "core/detect/inscribed_angles.hpp"

namespace scanbed {
namespace {

constexpr double kAnyDepth = std::numeric_limits<double>::infinity();

bool worth_analysing(const Points& points, const Segment& segment, const CircleOptions& options) {
  if (segment.num_points() < options.min_points) return false;
  const double length_m = (points[segment.last] - points[segment.first]).norm();
  if (length_m <= options.min_length_m || length_m >= options.max_length_m) return false;
  // Folded angles do not tell a hollow from a bulge: without the prerequisite at least the side must be
  // right.
  if (!options.prerequisite) return bulges_like_an_arc(points, segment, 0.0, kAnyDepth);
  return bulges_like_an_arc(points, segment, options.min_depth_ratio, options.max_depth_ratio);
}

// The three things that raise the paper's confidence (II-B): points in between, tightness, an average near 90
// degrees.
double score_of(int num_points, const InscribedAngles& angles, const CircleOptions& options) {
  const double many = 1.0 - 1.0 / num_points;
  const double tight = 1.0 - 0.5 * angles.std_rad / options.max_std_rad;
  const double half_in_view = 1.0 - 0.5 * std::abs(angles.average_rad - kPi / 2) / (kPi / 2);
  return many * tight * half_in_view;
}

}  // namespace

std::optional<Circle> detect_circle(const Points& points, const Segment& segment,
                                    const CircleOptions& options) {
  if (!worth_analysing(points, segment, options)) return std::nullopt;
  const std::optional<InscribedAngles> angles = inscribed_angles(points, segment, BehindChord::kFolded);
  if (!angles || angles->std_rad >= options.max_std_rad) return std::nullopt;
  if (angles->average_rad < options.min_average_rad || angles->average_rad > options.max_average_rad) {
    return std::nullopt;
  }
  if (angles->std_rad >= kMaxCircleStd_rad && is_v_corner(points, segment)) return std::nullopt;

  const Chord chord = chord_of(points, segment);
  const double theta_rad = angles->average_rad - kPi / 2;
  const double height_m = chord.length_m / 2 * std::tan(theta_rad);
  Circle circle;
  circle.beams = {points.beam[segment.first], points.beam[segment.last]};
  circle.center_m = (chord.from_m + chord.to_m) / 2 - height_m * chord.to_sensor;
  circle.radius_m = chord.length_m / 2 / std::cos(theta_rad);
  circle.average_rad = angles->average_rad;
  circle.std_rad = angles->std_rad;
  circle.score = score_of(segment.num_points(), *angles, options);
  return circle;
}

}  // namespace scanbed
