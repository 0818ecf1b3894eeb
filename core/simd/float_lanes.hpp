// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
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

/// Swaps neighbouring halves, quarters or single lanes: what is folded with it thrice is the same in all
/// lanes.
template <int kDistance, typename Lanes>
[[gnu::always_inline]] inline void swap_across(const Lanes& lanes, Lanes& swapped) {
  constexpr auto from = [](int lane) { return lane ^ kDistance; };
  swapped = __builtin_shufflevector(lanes, lanes, from(0), from(1), from(2), from(3), from(4), from(5),
                                    from(6), from(7));
}

/// The least of either's lanes.
struct LeastOfTwo {
  float first, second;
};
[[gnu::always_inline]] inline LeastOfTwo least_of(const Floats& first, const Floats& second) {
  // Lanes of both take turns, so that they are folded at once.
  Floats lanes = __builtin_shufflevector(first, second, 0, 8, 1, 9, 4, 12, 5, 13);
  Floats others = __builtin_shufflevector(first, second, 2, 10, 3, 11, 6, 14, 7, 15);
  lower(lanes, others);
  swap_across<4>(lanes, others);
  lower(lanes, others);
  swap_across<2>(lanes, others);
  lower(lanes, others);
  return {lanes[0], lanes[1]};
}

/// How often each of four comparisons held whose results were subtracted.
struct SumsOfFour {
  int first, second, third, fourth;
};
[[gnu::always_inline]] inline SumsOfFour sums_of(const Ints& first, const Ints& second, const Ints& third,
                                                 const Ints& fourth) {
  const auto fold_two = [](const Ints& a, const Ints& b, Ints& folded) {
    folded = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13) +
             __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  };
  Ints front, back, swapped;
  fold_two(first, second, front);
  fold_two(third, fourth, back);
  Ints lanes = __builtin_shufflevector(front, back, 0, 1, 8, 9, 4, 5, 12, 13) +
               __builtin_shufflevector(front, back, 2, 3, 10, 11, 6, 7, 14, 15);
  swap_across<4>(lanes, swapped);
  lanes += swapped;
  return {lanes[0], lanes[1], lanes[2], lanes[3]};
}

/// Of each lane.
[[gnu::always_inline]] inline void take_square_root(Floats& lanes) {
#if defined(__SSE2__)
  const __m128 low = _mm_sqrt_ps(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3));
  const __m128 high = _mm_sqrt_ps(__builtin_shufflevector(lanes, lanes, 4, 5, 6, 7));
  lanes = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  for (int i = 0; i < kNumLanes; ++i) lanes[i] = std::sqrt(lanes[i]);
#endif
}

}  // namespace scanbed
