// SPDX-License-Identifier: MIT
#include "core/random/philox.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scanbed {
namespace {

PhiloxCounter independent_philox(const PhiloxCounter& counter, const PhiloxKey& key) {
  const r123::Philox4x32::ctr_type c = {{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type k = {{key[0], key[1]}};
  const r123::Philox4x32::ctr_type answer = r123::Philox4x32{}(c, k);
  return {answer[0], answer[1], answer[2], answer[3]};
}

// The vectors that the authors publish with their library (kat_vectors, "philox4x32 10").
TEST(PhiloxTest, GivesThePublishedAnswers) {
  EXPECT_EQ(philox4x32_10({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32_10({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32_10({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

RC_GTEST_PROP(PhiloxTest, AgreesWithTheAuthorsLibrary, (const PhiloxCounter& counter, const PhiloxKey& key)) {
  RC_ASSERT(philox4x32_10(counter, key) == independent_philox(counter, key));
}

TEST(RandomSourceTest, AnswersAloneFromSeedNameScanBeamAndDraw) {
  const RandomSource source(7, "noise");
  EXPECT_EQ(source.bits(3, 200, 1), RandomSource(7, "noise").bits(3, 200, 1));
  const PhiloxCounter bits = source.bits(3, 200, 1);
  EXPECT_NE(bits, RandomSource(8, "noise").bits(3, 200, 1));
  EXPECT_NE(bits, RandomSource(7 + (std::uint64_t{1} << 32), "noise").bits(3, 200, 1));
  EXPECT_NE(bits, RandomSource(7, "bias").bits(3, 200, 1));
  EXPECT_NE(bits, source.bits(4, 200, 1));
  EXPECT_NE(bits, source.bits(3, 201, 1));
  EXPECT_NE(bits, source.bits(3, 200, 2));
}

constexpr int kNumScans = 500;
constexpr int kNumBeams = 400;
constexpr double kNumDraws = kNumScans * kNumBeams;

/// Mean of f over all draws.
template <typename Function>
double mean(const Function& f) {
  double sum = 0.0;
  for (int scan = 0; scan < kNumScans; ++scan) {
    for (int beam = 0; beam < kNumBeams; ++beam) sum += f(scan, beam);
  }
  return sum / kNumDraws;
}

// Tolerances are 4.5 standard errors of the estimate, from the moments of the distribution itself.
TEST(RandomSourceTest, UniformHasTheMomentsOfTheUnitInterval) {
  const RandomSource source(1, "uniform");
  EXPECT_NEAR(mean([&](int s, int b) { return source.uniform(s, b); }), 0.5,
              4.5 * std::sqrt(1.0 / 12 / kNumDraws));
  EXPECT_NEAR(mean([&](int s, int b) { return std::pow(source.uniform(s, b) - 0.5, 2); }), 1.0 / 12,
              4.5 * std::sqrt((1.0 / 80 - 1.0 / 144) / kNumDraws));
}

TEST(RandomSourceTest, NeighboursTogetherAreThoseOneByOne) {
  const RandomSource source(7, "noise");
  std::array<std::array<std::uint32_t, 8>, 4> words;
  source.bits(3, 100, words);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    const PhiloxCounter alone = source.bits(3, 100 + static_cast<int>(lane));
    for (std::size_t w = 0; w < 4; ++w) EXPECT_EQ(words[w][lane], alone[w]);
  }
}

TEST(RandomSourceTest, GaussianHasTheMomentsOfTheNormalDistribution) {
  const RandomSource source(1, "gaussian");
  EXPECT_NEAR(mean([&](int s, int b) { return source.gaussian(s, b); }), 0.0, 4.5 * std::sqrt(1 / kNumDraws));
  EXPECT_NEAR(mean([&](int s, int b) { return std::pow(source.gaussian(s, b), 2); }), 1.0,
              4.5 * std::sqrt(2 / kNumDraws));
  EXPECT_NEAR(mean([&](int s, int b) { return std::pow(source.gaussian(s, b), 3); }), 0.0,
              4.5 * std::sqrt(15 / kNumDraws));
  EXPECT_NEAR(mean([&](int s, int b) { return std::pow(source.gaussian(s, b), 4); }), 3.0,
              4.5 * std::sqrt(96 / kNumDraws));
}

TEST(RandomSourceTest, TheTailsOfTheGaussianAreThere) {
  const RandomSource source(2, "gaussian");
  const double beyond_3 = std::erfc(3.0 / std::sqrt(2.0));
  EXPECT_NEAR(mean([&](int s, int b) { return std::abs(source.gaussian(s, b)) > 3.0 ? 1.0 : 0.0; }), beyond_3,
              4.5 * std::sqrt(beyond_3 / kNumDraws));
}

TEST(RandomSourceTest, NeighbouringBeamsAndScansAreUncorrelated) {
  const RandomSource source(3, "gaussian");
  const double limit = 4.5 / std::sqrt(kNumDraws);
  EXPECT_NEAR(mean([&](int s, int b) { return source.gaussian(s, b) * source.gaussian(s, b + 1); }), 0,
              limit);
  EXPECT_NEAR(mean([&](int s, int b) { return source.gaussian(s, b) * source.gaussian(s + 1, b); }), 0,
              limit);
}

}  // namespace
}  // namespace scanbed
