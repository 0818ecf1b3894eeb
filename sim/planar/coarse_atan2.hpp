// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/geometry/angles.hpp"

namespace scanbed::sim {

inline constexpr double kCoarseAtan2Error_rad = 1.2e-5;  ///< greatest error of coarse_atan2

/// std::atan2 to within kCoarseAtan2Error_rad, several times faster: for finding the beams that a shape may
/// cover, never for a range. coarse_atan2(0, 0) is 0; the seam at +-pi is as std::atan2's, up to the error.
///
/// @par Source  Abramowitz & Stegun, "Handbook of Mathematical Functions", 1964, eq. 4.4.49.
inline double coarse_atan2(double y, double x) {
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const bool steep = ay > ax;
  const double small = steep ? ax : ay;
  const double large = steep ? ay : ax;
  if (large == 0.0) return 0.0;
  const double t = small / large;
  const double s = t * t;
  double angle_rad = t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  if (steep) angle_rad = kPi / 2 - angle_rad;
  if (x < 0.0) angle_rad = kPi - angle_rad;
  return y < 0.0 ? -angle_rad : angle_rad;
}

}  // namespace scanbed::sim
