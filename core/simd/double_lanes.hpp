// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "core/simd/instruction_set.hpp"

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

/// Four doubles at a time, in functions for wider instruction sets; always by reference, since how so wide a
/// vector is passed depends on the set.
using Quads [[gnu::vector_size(32)]] = double;

/// What a comparison of Quads gives: -1 where it holds, else 0.
using QuadMask [[gnu::vector_size(32)]] = std::int64_t;
using IntQuads [[gnu::vector_size(16)]] = std::int32_t;

inline constexpr int kNumQuadLanes = 4;

[[gnu::always_inline]] inline void load(const int* values, IntQuads& lanes) {
  std::memcpy(&lanes, values, sizeof lanes);
}

[[gnu::always_inline]] inline void load(const double* values, Doubles& lanes) {
  std::memcpy(&lanes, values, sizeof lanes);
}

[[gnu::always_inline]] inline void load(const double* values, Quads& lanes) {
  std::memcpy(&lanes, values, sizeof lanes);
}

/// Of a comparison: bit i says whether it held in lane i.
[[gnu::always_inline]] inline unsigned bits_of(const QuadMask& holds) {
#if defined(__SSE2__)
  __m128d halves[2];
  std::memcpy(halves, &holds, sizeof halves);
  return static_cast<unsigned>(_mm_movemask_pd(halves[0]) | _mm_movemask_pd(halves[1]) << 2);
#else
  unsigned bits = 0;
  for (int i = 0; i < kNumQuadLanes; ++i) bits |= holds[i] != 0 ? 1U << i : 0U;
  return bits;
#endif
}

/// By the bits of a comparison: the lanes where it held, in rising order, then any.
inline constexpr auto kLanesThatHold = [] {
  std::array<std::array<std::int32_t, kNumQuadLanes>, 1 << kNumQuadLanes> lanes{};
  for (unsigned bits = 0; bits < lanes.size(); ++bits) {
    int num_lanes = 0;
    for (int i = 0; i < kNumQuadLanes; ++i) {
      if ((bits >> i & 1U) != 0) lanes[bits][num_lanes++] = i;
    }
  }
  return lanes;
}();

#if defined(SCANBED_HAS_AVX2)
/// Writes the lanes whose bits are set, in their order, then others: four in any case.
[[gnu::always_inline]] SCANBED_AVX2 inline void store_kept(unsigned bits, const Quads& lanes,
                                                           double* values) {
  IntQuads kept;
  load(kLanesThatHold[bits].data(), kept);
  // Only single words can be chosen by variables: 2 k and 2 k + 1 are lane k.
  const __m256i low = _mm256_cvtepu32_epi64(reinterpret_cast<__m128i>(kept + kept));
  const __m256i high = _mm256_slli_epi64(_mm256_add_epi64(low, _mm256_set1_epi64x(1)), 32);
  const __m256 chosen = _mm256_permutevar8x32_ps(reinterpret_cast<__m256>(lanes), _mm256_or_si256(low, high));
  std::memcpy(values, &chosen, sizeof chosen);
}
#endif

/// Writes down the places whose bits are set, of four from the first on, and returns how many they are.
/// Writes four in any case: a jump would be a guess.
[[gnu::always_inline]] inline int list_places(unsigned bits, int first, int* places) {
  IntQuads lanes;
  load(kLanesThatHold[bits].data(), lanes);
  lanes += first;
  std::memcpy(places, &lanes, sizeof lanes);
  return std::popcount(bits);
}

}  // namespace scanbed
