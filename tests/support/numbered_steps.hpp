// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace scanbed::tests {

/// Millimetres that beam `beam` of scan `number` measures: each scan tells its number, and every beam can be
/// checked against it.
inline int numbered_steps(std::int64_t number, int beam) {
  if (beam == 0) return static_cast<int>(number % 8000);
  if (beam == 1) return static_cast<int>(number / 8000 % 8000);
  return static_cast<int>((number * 31 + beam * 17) % 8000);
}

}  // namespace scanbed::tests
