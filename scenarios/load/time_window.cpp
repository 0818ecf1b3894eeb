// SPDX-License-Identifier: MIT
#include "scenarios/load/time_window.hpp"

#include <fmt/format.h>

namespace scanbed::scenarios {

std::string to_string(const TimeWindow& window) {
  return fmt::format("{:g} to {:g} s", window.from_s, window.to_s);
}

}  // namespace scanbed::scenarios
