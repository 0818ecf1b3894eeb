// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace scanbed {

/// Which feature an object is to a detector.
enum class Primitive { kNone, kLine, kCircle, kLeg };

/// How much of an object a scan shows: resolvable must be found, marginal is neither hit nor miss, hidden is
/// no truth.
enum class Visibility { kResolvable, kMarginal, kHidden };

inline constexpr int kNoObject = -1;

/// What one beam truly met.
struct BeamTruth {
  int object = kNoObject;      ///< index into Truth::objects; kNoObject where nothing returned
  double range_m = 0.0;        ///< ideal range before the sensor's errors; kNoEcho where nothing returned
  double incidence_rad = 0.0;  ///< between the beam and the surface normal, [0, pi/2]
  bool mixed = false;          ///< the beam's spot met more than one surface
};

/// One object as one scan sees it, in the sensor frame S at the time of its middle clean beam.
struct ObjectTruth {
  std::string id;     ///< of the scenario: "col_L", "student_A.left_leg", "hall.2" (third wall of hall)
  std::string label;  ///< of the scenario: "wall", "column", "bench", "leg", "mobile_cylinder", ...
  Primitive primitive = Primitive::kNone;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< circle, leg: p_SC
  double radius_m = 0.0;                               ///< circle, leg
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();    ///< line: one end of the whole wall, p_SA
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();      ///< line: the other end, p_SB
  int num_clean_beams = 0;                             ///< beams that met this object alone
  Visibility visibility = Visibility::kHidden;
};

/// Ground truth of one scan, from a simulated or labelled source.
struct Truth {
  Pose2 X_WS;  ///< sensor in the world at the scan's time
  std::vector<BeamTruth> beams;
  std::vector<ObjectTruth> objects;
};

}  // namespace scanbed
