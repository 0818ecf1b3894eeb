// SPDX-License-Identifier: MIT
#include "core/detect/chord.hpp"

#include <algorithm>

namespace scanbed {

Chord chord_of(const Points& points, const Segment& segment) {
  Chord chord;
  chord.from_m = points[segment.first];
  chord.to_m = points[segment.last];
  const Eigen::Vector2d along_m = chord.to_m - chord.from_m;
  chord.length_m = along_m.norm();
  chord.to_sensor.setZero();
  if (chord.length_m > 0.0) {
    const Eigen::Vector2d normal = Eigen::Vector2d(-along_m.y(), along_m.x()) / chord.length_m;
    // The sensor is the origin; whichever way the beams turn, this normal points to it.
    chord.to_sensor = normal.dot(chord.from_m) <= 0.0 ? normal : Eigen::Vector2d(-normal);
  }
  return chord;
}

bool bulges_like_an_arc(const Points& points, const Segment& segment, double min_depth_ratio,
                        double max_depth_ratio) {
  const Chord chord = chord_of(points, segment);
  const int middle = (segment.first + segment.last) / 2;
  const int other_middle = segment.first + segment.last - middle;  // the same where their number is odd
  const double depth_m = std::max(chord.depth_m(points[middle]), chord.depth_m(points[other_middle]));
  return min_depth_ratio * chord.length_m < depth_m && depth_m < max_depth_ratio * chord.length_m;
}

}  // namespace scanbed
