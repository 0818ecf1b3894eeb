// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

namespace scanbed {

/// Eight numbers that are reckoned with at once, element by element, as GCC's and Clang's vector extensions
/// do. A comparison gives Ints: -1 where it holds, else 0.
inline constexpr int kNumLanes = 8;
using Floats = float __attribute__((vector_size(kNumLanes * sizeof(float))));
using Ints = std::int32_t __attribute__((vector_size(kNumLanes * sizeof(std::int32_t))));

// Into functions for any instruction set, so always inlined; by reference, since how a wide vector is passed
// depends on the set.

[[gnu::always_inline]] inline void load(const float* values, Floats& lanes) {
  std::memcpy(&lanes, values, sizeof lanes);
}

[[gnu::always_inline]] inline void load(const std::int32_t* values, Ints& lanes) {
  std::memcpy(&lanes, values, sizeof lanes);
}

[[gnu::always_inline]] inline void store(const Floats& lanes, float* values) {
  std::memcpy(values, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline void lower(Floats& least, const Floats& values) {
  least = values < least ? values : least;
}

[[gnu::always_inline]] inline void raise(Floats& greatest, const Floats& values) {
  greatest = values > greatest ? values : greatest;
}

inline float least_of(const Floats& lanes) {
  float least = lanes[0];
  for (int i = 1; i < kNumLanes; ++i) least = lanes[i] < least ? lanes[i] : least;
  return least;
}

inline float greatest_of(const Floats& lanes) {
  float greatest = lanes[0];
  for (int i = 1; i < kNumLanes; ++i) greatest = lanes[i] > greatest ? lanes[i] : greatest;
  return greatest;
}

/// How often a comparison held whose results were subtracted.
inline int sum_of(const Ints& lanes) {
  int sum = 0;
  for (int i = 0; i < kNumLanes; ++i) sum += lanes[i];
  return sum;
}

}  // namespace scanbed
