// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace scanbed {

/// From a point to the nearest one of a segment, which may have no length.
inline double segment_distance_m(const Eigen::Vector2d& p_m, const Eigen::Vector2d& from_m,
                                 const Eigen::Vector2d& to_m) {
  const Eigen::Vector2d along_m = to_m - from_m;
  const double length2_m2 = along_m.squaredNorm();
  const double share =
      length2_m2 > 0.0 ? std::clamp((p_m - from_m).dot(along_m) / length2_m2, 0.0, 1.0) : 0.0;
  return (p_m - from_m - share * along_m).norm();
}

}  // namespace scanbed
