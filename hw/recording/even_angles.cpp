// SPDX-License-Identifier: MIT
#include "hw/recording/even_angles.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <system_error>

#include "core/errors/ensure.hpp"

namespace scanbed::hw {

void restore_even_angles(ScanGeometry& geometry, const AngleRounding& rounding) {
  constexpr double kMostSteps = 1e6;
  const double num_steps = std::round(2.0 * kPi / std::abs(geometry.step_rad));
  if (!(num_steps >= 1.0 && num_steps <= kMostSteps)) return;
  if (!(std::abs(geometry.first_rad) <= 2.0 * kPi)) return;
  const double step_rad = std::copysign(2.0 * kPi / num_steps, geometry.step_rad);
  if (std::abs(step_rad - geometry.step_rad) > rounding.step_rad) return;
  geometry.step_rad = step_rad;
  // The first beam as the fraction h / N of pi; reduced, so that -360 / 720 gives -pi / 2 to the bit.
  const auto half_steps = static_cast<std::int64_t>(std::round(geometry.first_rad / kPi * num_steps));
  const auto all = static_cast<std::int64_t>(num_steps);
  const std::int64_t divisor = std::gcd(half_steps, all);
  const std::int64_t numerator = half_steps / divisor;
  const std::int64_t denominator = all / divisor;
  const double first_rad = static_cast<double>(numerator) * kPi / static_cast<double>(denominator);
  if (std::abs(first_rad - geometry.first_rad) <= rounding.first_rad) geometry.first_rad = first_rad;
}

double shortest_decimal(float value) {
  if (!std::isfinite(value)) return value;
  std::array<char, 32> digits;
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  double decimal = 0.0;
  SCANBED_ENSURE(std::from_chars(digits.data(), written.ptr, decimal).ec == std::errc());
  return decimal;
}

}  // namespace scanbed::hw
