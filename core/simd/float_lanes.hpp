// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

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

[[gnu::always_inline]] inline void store(const Ints& lanes, std::int32_t* values) {
  std::memcpy(values, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline void lower(Floats& least, const Floats& values) {
  least = values < least ? values : least;
}

[[gnu::always_inline]] inline void raise(Floats& greatest, const Floats& values) {
  greatest = values > greatest ? values : greatest;
}

/// Of a comparison: bit i says whether it held in lane i.
[[gnu::always_inline]] inline unsigned bits_of(const Ints& holds) {
#if defined(__SSE2__)
  Floats lanes;
  std::memcpy(&lanes, &holds, sizeof lanes);
  const __m128 low = __builtin_shufflevector(lanes, lanes, 0, 1, 2, 3);
  const __m128 high = __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7);
  return static_cast<unsigned>(_mm_movemask_ps(low) | _mm_movemask_ps(high) << 4);
#else
  unsigned bits = 0;
  for (int i = 0; i < kNumLanes; ++i) bits |= holds[i] != 0 ? 1U << i : 0U;
  return bits;
#endif
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
