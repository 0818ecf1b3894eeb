// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

namespace scanbed {

/// Two doubles that are worked on at a time, by the compilers' vector extension: a comparison gives a mask by
/// which `?:` chooses lane by lane, without a jump.
using Doubles [[gnu::vector_size(16)]] = double;

inline Doubles both_lanes(double value) {
  return Doubles{value, value};
}

/// Two neighbouring values; they need not be aligned.
inline Doubles lanes_at(const double* first) {
  Doubles lanes;
  std::memcpy(&lanes, first, sizeof lanes);
  return lanes;
}

inline Doubles swapped(Doubles lanes) {
  return Doubles{lanes[1], lanes[0]};
}

}  // namespace scanbed
