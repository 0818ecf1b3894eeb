// SPDX-License-Identifier: MIT
#include "sim/sensor/sensor_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/scan/laser_scan.hpp"
#include "sim/sensor/sensor_presets.hpp"

namespace scanbed::sim {
namespace {

SensorOptions with_sigma(double sigma_m) {
  SensorOptions options;
  options.noise_sigma_m = sigma_m;
  return options;
}

/// So many beams that all meet object 0 alike.
IdealReturns all_at(double range_m, double cos_incidence = 1.0, int num_beams = 361) {
  IdealReturns returns;
  returns.reset(num_beams);
  std::fill(returns.range_m.begin(), returns.range_m.end(), range_m);
  std::fill(returns.cos_incidence.begin(), returns.cos_incidence.end(), cos_incidence);
  std::fill(returns.object.begin(), returns.object.end(), 0);
  return returns;
}

std::vector<double> ranges_of(const SensorOptions& options, const IdealReturns& returns,
                              const Material& material = {}, std::uint64_t seed = 1, std::int64_t scan = 0) {
  SensorModel model(options, seed, {material, {.reflectivity = 0.2}, {.reflectivity = 0.8}});
  std::vector<double> range_m;
  model.measure(returns, scan, range_m);
  return range_m;
}

/// One beam whose spot met object 1 with share `near` of its light at near_m and object 2 at far_m.
IdealReturns two_surfaces(double near, double near_m, double far_m) {
  IdealReturns returns = all_at(near_m, 1.0, 1);
  returns.split_spots = {{0, 0, 2}};
  returns.spot_returns = {{1.0 - near, far_m, 1.0, 2}, {near, near_m, 1.0, 1}};
  return returns;
}

struct Moments {
  double mean;
  double variance;
  double count;
};

// Over `num_scans` scans of 361 beams.
Moments error_moments(const SensorOptions& options, const Material& material, double range_m, double cosine,
                      int num_scans = 200) {
  SensorModel model(options, 3, {material});
  const IdealReturns returns = all_at(range_m, cosine);
  std::vector<double> measured_m;
  double sum = 0.0;
  double sum_sq = 0.0;
  double count = 0.0;
  for (int scan = 0; scan < num_scans; ++scan) {
    model.measure(returns, scan, measured_m);
    for (const double r : measured_m) {
      if (!std::isfinite(r)) continue;
      sum += r - range_m;
      sum_sq += (r - range_m) * (r - range_m);
      ++count;
    }
  }
  const double mean = sum / count;
  return {mean, sum_sq / count - mean * mean, count};
}

TEST(SensorModelTest, WithoutNoiseGivesTheNearestStep) {
  const SensorOptions options = with_sigma(0.0);
  EXPECT_EQ(ranges_of(options, all_at(1.2344))[0], 1.234);
  EXPECT_EQ(ranges_of(options, all_at(8.1824))[0], kNoEcho);  // beyond 8.182
  EXPECT_EQ(ranges_of(options, all_at(8.1819))[0], 8.182);
  IdealReturns nothing;
  nothing.reset(2);
  EXPECT_EQ(ranges_of(options, nothing), (std::vector<double>{kNoEcho, kNoEcho}));
}

TEST(SensorModelTest, CentimetresAndMoreBitsReachFarther) {
  SensorOptions options = with_sigma(0.0);
  options.unit = RangeUnit::kCentimetre;
  EXPECT_EQ(ranges_of(options, all_at(12.344))[0], 12.34);
  EXPECT_EQ(ranges_of(options, all_at(81.83))[0], kNoEcho);
  options.unit = RangeUnit::kMillimetre;
  options.word_bits = 15;
  EXPECT_EQ(ranges_of(options, all_at(12.3444))[0], 12.344);
  options.max_range_m = 12.0;
  EXPECT_EQ(ranges_of(options, all_at(12.3444))[0], kNoEcho);
}

// Words have no code for it, exact ranges have what REP 117 asks for.
TEST(SensorModelTest, TooCloseIsInvalidInWordsAloneAndExactRangesAreNotRounded) {
  SensorOptions options = with_sigma(0.0);
  options.min_range_m = 0.1;
  EXPECT_TRUE(std::isnan(ranges_of(options, all_at(0.09))[0]));
  EXPECT_EQ(ranges_of(options, all_at(0.101))[0], 0.101);
  options.exact_ranges = true;
  EXPECT_EQ(ranges_of(options, all_at(1.23456789))[0], 1.23456789);
  EXPECT_EQ(ranges_of(options, all_at(0.09))[0], kTooClose);
  EXPECT_EQ(ranges_of(options, all_at(9.0))[0], kNoEcho);
}

// Published for the LMS 200: 5 mm (1 sigma), at most 15 mm systematic, from 1 to 8 m. The model's formulas
// say how both depend on range and surface; 4.5 standard errors, and the millimetre steps' variance.
TEST(SensorModelTest, SigmaAndBiasOfTheLms200AreThoseOfItsFormulasFrom1To8Metres) {
  const SensorOptions lms = sensor_preset("sick_lms200");
  for (const double range_m : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0}) {
    for (const double reflectivity : {0.2, 0.8}) {
      const Material material{.reflectivity = reflectivity};
      const double cosine = 0.9;
      const double strength = reflectivity * cosine / (range_m * range_m) / (0.1 / 100.0);
      const double variance = 25e-6 * (1.0 + 0.5 / strength);
      const double bias_m =
          0.005 * std::sin(2.0 * kPi * range_m / 3.0) + 0.005 * (1.0 - reflectivity) + 0.0005;
      const Moments moments = error_moments(lms, material, range_m, cosine);
      EXPECT_EQ(moments.count, 200.0 * 361.0);
      EXPECT_NEAR(moments.mean, bias_m, 4.5 * std::sqrt(variance / moments.count)) << range_m;
      EXPECT_NEAR(moments.variance, variance + 1e-6 / 12, 4.5 * variance * std::sqrt(2.0 / moments.count))
          << range_m;
      EXPECT_LE(std::abs(moments.mean), 0.015);
    }
  }
}

TEST(SensorModelTest, NoiseGrowsWithRangeAndWithRoughSurfaces) {
  SensorOptions options = with_sigma(0.003);
  options.noise.sigma_ratio = 0.01;
  const double variance = 0.003 * 0.003 + 0.04 * 0.04 + 0.02 * 0.02;
  const Moments moments = error_moments(options, {.roughness_m = 0.02}, 4.0, 1.0);
  EXPECT_NEAR(moments.variance, variance, 4.5 * variance * std::sqrt(2.0 / moments.count));
}

TEST(SensorModelTest, ScalesMultiplyEachEffectAndZeroSwitchesItOff) {
  SensorOptions options = sensor_preset("sick_lms200");
  const SensorModel once(options, 1, {});
  options.effects = {.noise = 2.0, .bias = 3.0, .dropout = 0.0};
  const SensorModel scaled(options, 1, {});
  const Material dark{.reflectivity = 0.01};
  EXPECT_DOUBLE_EQ(scaled.sigma_m(3.0, 0.8, dark), 2.0 * once.sigma_m(3.0, 0.8, dark));
  EXPECT_DOUBLE_EQ(scaled.bias_m(3.5, 0.8, dark), 3.0 * once.bias_m(3.5, 0.8, dark));
  EXPECT_EQ(once.loss_probability(8.0, 0.8, dark), 1.0);
  EXPECT_EQ(scaled.loss_probability(8.0, 0.8, dark), 0.0);
  options.effects = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (const double r : ranges_of(options, all_at(3.333), dark)) EXPECT_EQ(r, 3.333);
}

// At the reach of a 10 % surface strength is 1: seen; at twice the reach 1/4: lost; at strength 5/8 half.
TEST(SensorModelTest, WeakEchoesAreLostWithThePublishedProbability) {
  SensorOptions options = with_sigma(0.0);
  options.word_bits = 15;
  options.dropout.reach_m = 10.0;
  const Material black{.reflectivity = 0.1};
  const auto share_lost = [&](double range_m) {
    double lost = 0.0;
    SensorModel model(options, 5, {black});
    std::vector<double> measured_m;
    for (int scan = 0; scan < 100; ++scan) {
      model.measure(all_at(range_m), scan, measured_m);
      lost += static_cast<double>(std::count(measured_m.begin(), measured_m.end(), kNoEcho));
    }
    return lost / 36100.0;
  };
  EXPECT_EQ(share_lost(9.99), 0.0);
  EXPECT_EQ(share_lost(20.01), 1.0);
  EXPECT_NEAR(share_lost(10.0 / std::sqrt(0.625)), 0.5, 4.5 * 0.5 / std::sqrt(36100.0));
}

TEST(SensorModelTest, GrazingSurfacesAreLostBeforeTheyAreFar) {
  SensorOptions options = with_sigma(0.0);
  options.dropout.reach_m = 10.0;
  const SensorModel model(options, 1, {});
  EXPECT_EQ(model.loss_probability(4.0, 1.0, {}), 0.0);
  EXPECT_EQ(model.loss_probability(4.0, std::cos(radians(89.9)), {}), 1.0);
}

TEST(SensorModelTest, GlassIsSeenHeadOnOnlyAndItsGlintDazzles) {
  SensorOptions options = with_sigma(0.0);
  const Material glass{.reflectivity = 0.9, .glass = true};
  EXPECT_EQ(ranges_of(options, all_at(3.0, std::cos(radians(3.9))), glass)[0], 3.0);
  EXPECT_EQ(ranges_of(options, all_at(3.0, std::cos(radians(4.1))), glass)[0], kNoEcho);
  options.dazzle.glint_rad = radians(0.3);
  EXPECT_TRUE(std::isnan(ranges_of(options, all_at(3.0, std::cos(radians(0.2))), glass)[0]));
  EXPECT_EQ(ranges_of(options, all_at(3.0, std::cos(radians(0.4))), glass)[0], 3.0);
  options.effects.dazzle = 0.0;
  EXPECT_EQ(ranges_of(options, all_at(3.0, 1.0), glass)[0], 3.0);
}

TEST(SensorModelTest, StrayLightDazzlesWithItsProbability) {
  SensorOptions options = with_sigma(0.0);
  options.dazzle.probability = 0.2;
  const std::vector<double> range_m = ranges_of(options, all_at(3.0, 1.0, 20000));
  const auto dazzled = std::count_if(range_m.begin(), range_m.end(), [](double r) { return std::isnan(r); });
  EXPECT_NEAR(static_cast<double>(dazzled) / 20000, 0.2, 4.5 * std::sqrt(0.2 * 0.8 / 20000));
}

// The light of each surface: share of the spot x reflectivity x cosine (here 1): 0.5 x 0.2 and 0.5 x 0.8.
TEST(SensorModelTest, SurfacesWithinAPulseBlendByTheirLight) {
  SensorOptions options = with_sigma(0.0);
  options.spot.pulse_m = 0.5;
  EXPECT_NEAR(ranges_of(options, two_surfaces(0.5, 4.0, 4.4))[0], 0.2 * 4.0 + 0.8 * 4.4, 0.0005 + 1e-9);
}

// Farther apart, the brighter one alone: light over range squared.
TEST(SensorModelTest, OfSurfacesFartherApartTheStrongestIsMeasured) {
  SensorOptions options = with_sigma(0.0);
  options.spot.pulse_m = 0.5;
  EXPECT_EQ(ranges_of(options, two_surfaces(0.5, 4.0, 6.0))[0], 6.0);  // 0.1 / 16 < 0.4 / 36
  EXPECT_EQ(ranges_of(options, two_surfaces(0.7, 4.0, 6.0))[0], 4.0);  // 0.14 / 16 > 0.24 / 36
  EXPECT_EQ(ranges_of(options, two_surfaces(0.5, 3.0, 7.0))[0], 3.0);  // 0.1 / 9 > 0.4 / 49
}

TEST(SensorModelTest, ASpotHalfInTheVoidMeasuresTheOtherHalf) {
  SensorOptions options = with_sigma(0.0);
  IdealReturns returns = two_surfaces(0.3, 4.0, 6.0);
  returns.spot_returns[0] = {0.7, kNoEcho, 1.0, kNoObject};
  EXPECT_EQ(ranges_of(options, returns)[0], 4.0);
}

TEST(SensorModelTest, TheSameBeamGetsTheSameNoiseWhateverCameBefore) {
  const SensorOptions options = with_sigma(0.1);
  const IdealReturns returns = all_at(4.0);
  SensorModel model(options, 5, {{}});
  std::vector<double> early, late;
  for (const std::int64_t scan : {7, 2, 9}) model.measure(returns, scan, early);
  model.measure(returns, 3, late);
  EXPECT_EQ(late, ranges_of(options, returns, {}, 5, 3));
  EXPECT_EQ(ranges_of(options, all_at(4.0, 1.0, 181), {}, 5, 3),
            std::vector<double>(late.begin(), late.begin() + 181));
  const std::vector<double> other = ranges_of(options, returns, {}, 6, 3);
  int num_equal = 0;
  for (int i = 0; i < 361; ++i) num_equal += other[i] == late[i];
  EXPECT_LT(num_equal, 20);  // 1 in 350 coincides by chance: steps of 1 mm under a sigma of 100 mm
}

TEST(SensorModelTest, NoiseNearTheEndsStaysARange) {
  const std::vector<double> far_m = ranges_of(with_sigma(0.05), all_at(8.1825, 1.0, 1000));
  EXPECT_TRUE(std::all_of(far_m.begin(), far_m.end(), [](double r) { return r <= 8.182 || r == kNoEcho; }));
  // Half of a symmetric distribution falls on either side; 4.5 standard deviations of a binomial.
  EXPECT_NEAR(static_cast<double>(std::count(far_m.begin(), far_m.end(), kNoEcho)), 500, 75);
  const std::vector<double> near_m = ranges_of(with_sigma(0.05), all_at(0.0, 1.0, 1000));
  EXPECT_NEAR(static_cast<double>(std::count(near_m.begin(), near_m.end(), 0.0)), 500,
              80);  // and half a step
}

}  // namespace
}  // namespace scanbed::sim
