// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "core/geometry/angles.hpp"

namespace scanbed {

/// When each beam of a sweep is measured. An interlaced scan consists of several rotations: with two, as in
/// the LMS 200 at 0.5 degrees, even beams come from the first and odd beams from the second.
struct BeamTiming {
  int num_rotations = 1;    ///< rotations interlaced into one scan, >= 1
  double rotation_s = 0.0;  ///< from the start of one rotation to the start of the next
  double step_s = 0.0;      ///< between consecutive beams of one rotation

  /// Time of beam i after the scan's own time.
  double offset_s(int beam) const {
    const int place = beam / num_rotations;  // of the beam within its rotation
    return (beam % num_rotations) * rotation_s + place * step_s;
  }
};

/// Where the beams of a scan point. Sensor frame S: x forward, y left, angles counter-clockwise from x (REP
/// 103); beam 0 is the rightmost where step_rad is positive. The default is the LMS 200's 180 degrees at 0.5
/// degrees.
struct ScanGeometry {
  int num_beams = 361;
  double first_rad = -kPi / 2;
  double step_rad = kPi / 360;  ///< negative for a sensor that turns clockwise
  double min_range_m = 0.0;
  double max_range_m = std::numeric_limits<double>::infinity();
  BeamTiming timing;

  double bearing_rad(int beam) const { return first_rad + beam * step_rad; }

  /// Which beam points to a bearing, and where between two: the first at or behind -0.5, within a full turn.
  /// Not a number where the angles say nothing.
  double beam_towards(double bearing_rad) const {
    const double turn = 2.0 * kPi / std::abs(step_rad);
    const double beam = (bearing_rad - first_rad) / step_rad;
    return beam - turn * std::floor((beam + 0.5) / turn);
  }

  friend bool operator==(const ScanGeometry& a, const ScanGeometry& b) {
    return a.num_beams == b.num_beams && a.first_rad == b.first_rad && a.step_rad == b.step_rad;
  }
};

/// What is wrong with a geometry that no sensor has: beams spread over more than a turn, numbers that are not
/// finite; empty where nothing is.
std::string_view fault_of(const ScanGeometry& geometry);

/// @throws InputError for such a geometry.
void check_geometry(const ScanGeometry& geometry);

}  // namespace scanbed
