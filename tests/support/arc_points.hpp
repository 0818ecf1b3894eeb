// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/detect/points.hpp"
#include "core/detect/segmentation.hpp"

namespace scanbed::testing {

/// Appends a point; beams are numbered as the points come.
inline void append(Points& points, const Eigen::Vector2d& p_SQ) {
  points.x_m.push_back(p_SQ.x());
  points.y_m.push_back(p_SQ.y());
  points.beam.push_back(static_cast<int>(points.beam.size()));
}

/// The arc of a circle that faces the sensor at the origin, as num_points points at equal angles.
inline Points arc(const Eigen::Vector2d& center_m, double radius_m, double central_angle_rad,
                  int num_points) {
  Points points;
  const double middle_rad = std::atan2(-center_m.y(), -center_m.x());
  for (int i = 0; i < num_points; ++i) {
    // From the sensor's right to its left: clockwise around the centre.
    const double angle_rad =
        middle_rad + central_angle_rad * (0.5 - static_cast<double>(i) / (num_points - 1));
    append(points, center_m + radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return points;
}

inline Segment all_of(const Points& points) {
  return {0, points.size() - 1};
}

}  // namespace scanbed::testing
