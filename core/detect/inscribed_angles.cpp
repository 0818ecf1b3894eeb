// SPDX-License-Identifier: MIT
#include "core/detect/inscribed_angles.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"

namespace scanbed {

double inscribed_angle_rad(const Chord& chord, const Eigen::Vector2d& p_SQ, BehindChord behind) {
  const Eigen::Vector2d to_first_m = chord.from_m - p_SQ;
  const Eigen::Vector2d to_last_m = chord.to_m - p_SQ;
  const double cross = to_first_m.x() * to_last_m.y() - to_first_m.y() * to_last_m.x();
  // |cross| is chord length times distance from the chord; its sign says on which side the point lies.
  const double angle_rad = std::atan2(std::abs(cross), to_first_m.dot(to_last_m));
  const bool reflex = behind == BehindChord::kReflex && chord.depth_m(p_SQ) < 0.0;
  return reflex ? 2.0 * kPi - angle_rad : angle_rad;
}

std::optional<InscribedAngles> inscribed_angles(const Points& points, const Segment& segment,
                                                BehindChord behind) {
  const int num_inner = segment.num_points() - 2;
  if (num_inner < 1) return std::nullopt;
  const Chord chord = chord_of(points, segment);
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (int k = segment.first + 1; k < segment.last; ++k) {
    // From pi, so that the squares of a line's angles do not cancel.
    const double from_pi = inscribed_angle_rad(chord, points[k], behind) - kPi;
    sum += from_pi;
    sum_of_squares += from_pi * from_pi;
  }
  const double mean = sum / num_inner;
  const double variance = sum_of_squares / num_inner - mean * mean;
  return InscribedAngles{kPi + mean, std::sqrt(std::max(0.0, variance))};
}

bool is_v_corner(const Points& points, const Segment& segment) {
  const Chord chord = chord_of(points, segment);
  const auto angle = [&](int k) { return inscribed_angle_rad(chord, points[k], BehindChord::kFolded); };
  int smallest = segment.first + 1;
  for (int k = smallest + 1; k < segment.last; ++k) {
    if (angle(k) < angle(smallest)) smallest = k;
  }
  if (smallest - 2 <= segment.first || smallest + 2 >= segment.last) return false;
  return angle(smallest - 2) > angle(smallest - 1) && angle(smallest - 1) > angle(smallest) &&
         angle(smallest + 1) > angle(smallest) && angle(smallest + 2) > angle(smallest + 1);
}

}  // namespace scanbed
