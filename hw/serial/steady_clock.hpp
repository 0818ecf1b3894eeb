// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace scanbed::hw {

/// Seconds of a clock that never jumps; its zero means nothing.
inline double steady_now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace scanbed::hw
