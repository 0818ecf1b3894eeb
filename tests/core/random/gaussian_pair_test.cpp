// SPDX-License-Identifier: MIT
#include "core/random/gaussian_pair.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "core/random/philox.hpp"

namespace scanbed {
namespace {

TEST(GaussianPairTest, TheLogarithmIsTheLibrarysAtAllMagnitudes) {
  const auto check = [](std::uint32_t word) {
    const double expected = -std::log((static_cast<double>(word) + 0.5) * 0x1p-32);
    EXPECT_NEAR(minus_log_of_unit(word), expected, 4e-15 * (1.0 + expected)) << word;
  };
  for (std::uint32_t word : {0U, 1U, 2U, 0x7FFFFFFFU, 0x80000000U, 0xB504F333U, 0xB504F334U, 0xFFFFFFFFU})
    check(word);
  for (std::uint32_t k = 0; k < 20000; ++k) check(philox4x32_10({k, 0, 0, 0}, {1, 2})[0] >> (k % 32));
}

TEST(GaussianPairTest, CosineAndSineAreTheLibrarysToAnEighthOfATurn) {
  for (double a = -0.25 * kPi; a <= 0.25 * kPi; a += 1e-3) {
    const auto [cosine, sine] = cos_sin_near_zero(a);
    EXPECT_NEAR(cosine, std::cos(a), 1e-13);
    EXPECT_NEAR(sine, std::sin(a), 1e-13);
  }
}

TEST(GaussianPairTest, TheSineOfTurnsIsTheLibrarysAllTheWayRound) {
  for (double turns = -3.0; turns <= 3.0; turns += 0.0137) {
    EXPECT_NEAR(sine_of_turns(turns), std::sin(2.0 * kPi * turns), 1e-12) << turns;
  }
  EXPECT_EQ(sine_of_turns(0.0), 0.0);
}

// Moments of the normal distribution: 0, 1, 0, 3; each estimate within 4.5 of its standard errors. And so for
// the product of the two, whose mean is 0 and variance 1.
TEST(GaussianPairTest, MomentsAreThoseOfTheNormalDistribution) {
  constexpr int kNum = 200000;
  std::array<double, 4> sums{};
  double products = 0.0;
  for (std::uint32_t k = 0; k < kNum; ++k) {
    const PhiloxCounter bits = philox4x32_10({k, 0, 0, 0}, {7, 9});
    const auto [a, b] = gaussian_pair(bits[0], bits[1]);
    for (const double x : {a, b}) {
      sums[0] += x;
      sums[1] += x * x;
      sums[2] += x * x * x;
      sums[3] += x * x * x * x;
    }
    products += a * b;
  }
  constexpr double kDraws = 2.0 * kNum;
  EXPECT_NEAR(sums[0] / kDraws, 0.0, 4.5 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(sums[1] / kDraws, 1.0, 4.5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(sums[2] / kDraws, 0.0, 4.5 * std::sqrt(15.0 / kDraws));
  EXPECT_NEAR(sums[3] / kDraws, 3.0, 4.5 * std::sqrt(96.0 / kDraws));
  EXPECT_NEAR(products / kNum, 0.0, 4.5 / std::sqrt(static_cast<double>(kNum)));
}

// The distribution function at -3 ... 3, against erfc.
TEST(GaussianPairTest, TailsAreThoseOfTheNormalDistribution) {
  constexpr int kNum = 200000;
  std::array<int, 7> below{};
  for (std::uint32_t k = 0; k < kNum; ++k) {
    const PhiloxCounter bits = philox4x32_10({k, 1, 0, 0}, {7, 9});
    const double x = gaussian_pair(bits[2], bits[3]).second;
    for (int limit = -3; limit <= 3; ++limit) below[limit + 3] += x < limit;
  }
  for (int limit = -3; limit <= 3; ++limit) {
    const double p = 0.5 * std::erfc(-limit / std::sqrt(2.0));
    EXPECT_NEAR(static_cast<double>(below[limit + 3]) / kNum, p, 4.5 * std::sqrt(p * (1.0 - p) / kNum))
        << limit;
  }
}

TEST(GaussianPairTest, ExtremeWordsGiveFiniteNumbers) {
  for (const std::uint32_t a : {0U, 0xFFFFFFFFU}) {
    for (const std::uint32_t b : {0U, 0x3FFFFFFFU, 0x40000000U, 0x80000000U, 0xFFFFFFFFU}) {
      const auto [x, y] = gaussian_pair(a, b);
      EXPECT_LT(std::hypot(x, y), 6.77);
      EXPECT_NEAR(std::hypot(x, y), std::sqrt(-2.0 * std::log((a + 0.5) * 0x1p-32)), 1e-12);
    }
  }
}

}  // namespace
}  // namespace scanbed
