// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace scanbed::hw {

/// Seconds to whole nanoseconds and back. The way there and back keeps a time to half a nanosecond, and to
/// the bit where its double is coarser than that.
struct NanoTime {
  std::uint64_t sec = 0;
  std::uint32_t nsec = 0;
};

/// @throws InputError where the time is before 0, not finite, or beyond the year 2106 (32 bits of seconds).
NanoTime to_nano_time(double time_s);
inline double to_seconds(const NanoTime& time) {
  return static_cast<double>(time.sec) + time.nsec * 1e-9;
}

}  // namespace scanbed::hw
