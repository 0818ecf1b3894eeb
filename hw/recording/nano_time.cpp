// SPDX-License-Identifier: MIT
#include "hw/recording/nano_time.hpp"

#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"
#include "core/text/number_text.hpp"

namespace scanbed::hw {

NanoTime to_nano_time(double time_s) {
  constexpr double kEnd_s = 4294967295.0;
  if (!(time_s >= 0.0 && time_s < kEnd_s)) {
    throw InputError("a scan's time of " + number_text(time_s) + " s cannot be recorded in this format; " +
                     "allowed: 0 <= time < 2^32 - 1 s");
  }
  const double whole_s = std::floor(time_s);
  const auto nsec = static_cast<std::uint32_t>(std::llround((time_s - whole_s) * 1e9));
  const auto sec = static_cast<std::uint64_t>(whole_s);
  if (nsec < 1'000'000'000U) return {sec, nsec};
  return {sec + 1, 0};
}

}  // namespace scanbed::hw
