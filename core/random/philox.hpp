// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/geometry/angles.hpp"

namespace scanbed {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// Philox4x32 with ten rounds: 128 random bits, a pure function of counter and key. Of several counters at
/// once, word by word: word w of lane's counter is counters[w][lane].
///
/// @par Source  Salmon, Moraes, Dror & Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3", SC 2011,
///              section 4.3; multipliers and Weyl constants as published there.
template <std::size_t kLanes>
constexpr void philox4x32_10(std::array<std::array<std::uint32_t, kLanes>, 4>& counters, PhiloxKey key) {
  for (int round = 0; round < 10; ++round) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::uint64_t product_0 = std::uint64_t{0xD2511F53U} * counters[0][lane];
      const std::uint64_t product_2 = std::uint64_t{0xCD9E8D57U} * counters[2][lane];
      counters[0][lane] = static_cast<std::uint32_t>(product_2 >> 32) ^ counters[1][lane] ^ key[0];
      counters[1][lane] = static_cast<std::uint32_t>(product_2);
      counters[2][lane] = static_cast<std::uint32_t>(product_0 >> 32) ^ counters[3][lane] ^ key[1];
      counters[3][lane] = static_cast<std::uint32_t>(product_0);
    }
    key[0] += 0x9E3779B9U;
    key[1] += 0xBB67AE85U;
  }
}

constexpr PhiloxCounter philox4x32_10(const PhiloxCounter& counter, PhiloxKey key) {
  std::array<std::array<std::uint32_t, 1>, 4> one = {
      {{counter[0]}, {counter[1]}, {counter[2]}, {counter[3]}}};
  philox4x32_10(one, key);
  return {one[0][0], one[1][0], one[2][0], one[3][0]};
}

/// Random numbers that one source of randomness ("lms.range_noise") draws for each beam of each scan: no
/// state, so the order of questions and the number of workers change nothing.
///
/// Scans are told apart up to the 2^32nd. Each `draw` of a beam is independent of the others.
class RandomSource {
 public:
  constexpr RandomSource(std::uint64_t seed, std::string_view name)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}, name_(hash(name)) {}

  constexpr PhiloxCounter bits(std::int64_t scan, int beam, std::uint32_t draw = 0) const {
    return philox4x32_10({static_cast<std::uint32_t>(beam), static_cast<std::uint32_t>(scan), name_, draw},
                         key_);
  }

  /// bits() of as many neighbouring beams: words[w][lane] is word w of beam first_beam + lane.
  template <std::size_t kLanes>
  void bits(std::int64_t scan, int first_beam,
            std::array<std::array<std::uint32_t, kLanes>, 4>& words) const {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      words[0][lane] = static_cast<std::uint32_t>(first_beam) + static_cast<std::uint32_t>(lane);
    }
    words[1].fill(static_cast<std::uint32_t>(scan));
    words[2].fill(name_);
    words[3].fill(0);
    philox4x32_10(words, key_);
  }

  /// Uniform in the open interval (0, 1), in steps of 2^-52.
  constexpr double uniform(std::int64_t scan, int beam, std::uint32_t draw = 0) const {
    const PhiloxCounter b = bits(scan, beam, draw);
    return to_unit_interval(b[0], b[1]);
  }

  /// Normal with mean 0 and standard deviation 1 (Box & Muller 1958, the cosine branch); |value| < 8.6.
  double gaussian(std::int64_t scan, int beam, std::uint32_t draw = 0) const {
    const PhiloxCounter b = bits(scan, beam, draw);
    const double radius = std::sqrt(-2.0 * std::log(to_unit_interval(b[0], b[1])));
    return radius * std::cos(2.0 * kPi * to_unit_interval(b[2], b[3]));
  }

 private:
  // The half keeps 0 and 1 out, where the logarithm has no value and the cosine repeats itself; with 52 bits
  // the sum is exact.
  static constexpr double to_unit_interval(std::uint32_t low, std::uint32_t high) {
    const std::uint64_t word = (std::uint64_t{high} << 32) | low;
    return (static_cast<double>(word >> 12) + 0.5) * 0x1p-52;
  }

  // FNV-1a, 32 bits: the same on every platform, unlike std::hash.
  static constexpr std::uint32_t hash(std::string_view name) {
    std::uint32_t value = 2166136261U;
    for (const char c : name) value = (value ^ static_cast<unsigned char>(c)) * 16777619U;
    return value;
  }

  PhiloxKey key_;
  std::uint32_t name_;
};

}  // namespace scanbed
