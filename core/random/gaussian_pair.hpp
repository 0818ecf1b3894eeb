// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/geometry/angles.hpp"

namespace scanbed {

// Elementary functions of random words by additions, multiplications, one division and square roots alone:
// the same bits from every compiler and mathematical library, unlike std::log, std::sin and std::cos.

/// -ln u with u = (word + 1/2) / 2^32, to within 4e-15 of the value or better.
///
/// @par Source  ln m = 2 artanh((m - 1) / (m + 1)), its power series at m in [sqrt 1/2, sqrt 2].
inline double minus_log_of_unit(std::uint32_t word) {
  constexpr double kLn2 = 0.693147180559945309417;
  const auto u = static_cast<double>(word) + 0.5;  // of 2^32
  // Adding the upper bits of sqrt 1/2's distance to 1 moves the exponent up where the mantissa is above
  // sqrt 2.
  const auto bits = std::bit_cast<std::uint64_t>(u);
  const std::uint64_t lifted = bits + 0x00095F619980C433ULL;
  const auto exponent = static_cast<double>(static_cast<std::int32_t>(lifted >> 52) - 1023 - 32);
  const auto m = std::bit_cast<double>((lifted & 0x000FFFFFFFFFFFFFULL) + 0x3FE6A09E667F3BCDULL);
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  const double series =
      1.0 + s2 * (1.0 / 3 +
                  s2 * (1.0 / 5 +
                        s2 * (1.0 / 7 +
                              s2 * (1.0 / 9 +
                                    s2 * (1.0 / 11 + s2 * (1.0 / 13 + s2 * (1.0 / 15 + s2 * (1.0 / 17))))))));
  return -(exponent * kLn2 + 2.0 * s * series);
}

/// (cos, sin) of an angle within an eighth of a turn of 0.
inline std::pair<double, double> cos_sin_near_zero(double angle_rad) {
  const double a2 = angle_rad * angle_rad;
  // Taylor's series; of constants the compiler makes one factor each.
  const double cosine =
      1.0 +
      a2 * (-1.0 / 2 +
            a2 * (1.0 / 24 +
                  a2 * (-1.0 / 720 +
                        a2 * (1.0 / 40320 +
                              a2 * (-1.0 / 3628800 + a2 * (1.0 / 479001600 - a2 * (1.0 / 87178291200.0)))))));
  const double sine =
      angle_rad *
      (1.0 +
       a2 * (-1.0 / 6 +
             a2 * (1.0 / 120 + a2 * (-1.0 / 5040 + a2 * (1.0 / 362880 + a2 * (-1.0 / 39916800 +
                                                                              a2 * (1.0 / 6227020800.0)))))));
  return {cosine, sine};
}

/// sin(2 pi turns) to within 1e-12; |turns| < 5e8.
inline double sine_of_turns(double turns) {
  const double quarters = 4.0 * turns;
  const auto quadrant = static_cast<std::int32_t>(quarters < 0.0 ? quarters - 0.5 : quarters + 0.5);
  const auto [cosine, sine] = cos_sin_near_zero((quarters - static_cast<double>(quadrant)) * (kPi / 2));
  // Selected rather than branched to, so that compilers can treat several at once.
  const double value = (quadrant & 1) != 0 ? cosine : sine;
  return (quadrant & 2) != 0 ? -value : value;
}

/// Two independent normal numbers with mean 0 and standard deviation 1; |value| < 6.77.
///
/// @par Source  Box & Muller, "A Note on the Generation of Random Normal Deviates", Ann. Math. Stat. 1958.
inline std::pair<double, double> gaussian_pair(std::uint32_t radius_word, std::uint32_t angle_word) {
  const double radius = std::sqrt(2.0 * minus_log_of_unit(radius_word));
  // The upper two bits pick the quadrant, the others the angle in it.
  constexpr double kStep_rad = kPi / 2 / (1U << 30);
  const double angle_rad =
      (static_cast<double>(static_cast<std::int32_t>(angle_word & 0x3FFFFFFFU)) + 0.5) * kStep_rad - kPi / 4;
  const auto [cosine, sine] = cos_sin_near_zero(angle_rad);
  const bool swap = (angle_word & 0x40000000U) != 0;
  const double sign = (angle_word & 0x80000000U) != 0 ? -radius : radius;
  return {sign * (swap ? -sine : cosine), sign * (swap ? cosine : sine)};
}

}  // namespace scanbed
