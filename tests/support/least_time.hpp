// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <limits>

#include "hw/serial/steady_clock.hpp"

namespace scanbed::tests {

/// The least time that an action takes in a few tries, fewer where one is within `enough_s`. A busy machine
/// makes any of them longer, none shorter: what the least one exceeds, the code itself waits for.
inline double least_seconds(double enough_s, const std::function<void()>& action) {
  constexpr int kMostTries = 8;
  double least_s = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostTries && least_s > enough_s; ++i) {
    const double start_s = hw::steady_now_s();
    action();
    least_s = std::min(least_s, hw::steady_now_s() - start_s);
  }
  return least_s;
}

}  // namespace scanbed::tests
