// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace scanbed::hw {

/// Whether a number can be the time of a scan: within 30 000 years of 0. Sums of such times are finite, and
/// their doubles tell milliseconds apart.
inline bool is_time(double time_s) {
  return std::abs(time_s) <= 1e12;
}

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
