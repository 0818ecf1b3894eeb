// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

namespace scanbed {

/// Two doubles that are worked on at a time, by the compilers' vector extension: a comparison gives a mask by
/// which `?:` chooses lane by lane, without a jump.
using Lanes [[gnu::vector_size(16)]] = double;

inline Lanes both_lanes(double value) {
  return Lanes{value, value};
}

/// Two neighbouring values; they need not be aligned.
inline Lanes lanes_at(const double* first) {
  Lanes lanes;
  std::memcpy(&lanes, first, sizeof lanes);
  return lanes;
}

inline Lanes swapped(Lanes lanes) {
  return Lanes{lanes[1], lanes[0]};
}

}  // namespace scanbed
