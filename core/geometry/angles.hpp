// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace scanbed {

inline constexpr double kPi = std::numbers::pi;

/// The same direction as an angle in [-pi, pi].
inline double wrap_to_pi(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * kPi);
}

constexpr double radians(double angle_deg) {
  return angle_deg * kPi / 180.0;
}
constexpr double degrees(double angle_rad) {
  return angle_rad * 180.0 / kPi;
}

}  // namespace scanbed
