// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace scanbed {

enum class TrackKind { kPerson, kCylinder, kLeg };

inline constexpr int kNoFeature = -1;

/// Something followed from scan to scan, as it is at the latest of them.
struct Track {
  int id = 0;  ///< of this track alone, from 1
  TrackKind kind = TrackKind::kLeg;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< sensor frame S; a person's: between its legs
  Eigen::Vector2d velocity_m_per_s = Eigen::Vector2d::Zero();  ///< over ground, along the axes of S
  double radius_m = 0.0;                                       ///< of a cylinder
  double score = 0.0;                                          ///< [0, 1], from all scans so far
  bool is_mobile = false;                                      ///< it has been seen to change its place
  bool is_settled = false;  ///< it has been watched long enough, standing still, to say that it is not moving
  int feature = kNoFeature;         ///< this scan's circle or leg that it was seen in, index into their list
  int second_feature = kNoFeature;  ///< a person's other leg
};

}  // namespace scanbed
