// SPDX-License-Identifier: MIT
#include "sim/sensor/lms_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {
namespace {

LmsOptions with_sigma(double sigma_m) {
  LmsOptions options;
  options.noise_sigma_m = sigma_m;
  return options;
}

TEST(LmsModelTest, WithoutNoiseGivesTheNearestStep) {
  const LmsModel model(with_sigma(0.0), 1);
  EXPECT_EQ(model.measure(1.2344, 0, 0), 1234);
  EXPECT_EQ(model.measure(8.1824, 0, 0), 8182);
  EXPECT_EQ(model.measure(8.183, 0, 0), kLmsBeyondMax);
  EXPECT_EQ(model.measure(kNoEcho, 0, 0), kLmsNoStopSignal);
}

TEST(LmsModelTest, InCentimetresReachesTenTimesAsFar) {
  LmsOptions options = with_sigma(0.0);
  options.unit = RangeUnit::kCentimetre;
  const LmsModel model(options, 1);
  EXPECT_EQ(model.measure(12.344, 0, 0), 1234);
  EXPECT_EQ(model.measure(81.83, 0, 0), kLmsBeyondMax);
}

TEST(LmsModelTest, NoiseHasMeanZeroAndItsSigma) {
  const LmsModel model(with_sigma(0.02), 5);
  constexpr int kNum = 100000;
  double sum = 0.0;
  double sum_sq = 0.0;
  for (int i = 0; i < kNum; ++i) {
    const double error_m = model.measure(4.0, i / 361, i % 361) / 1000.0 - 4.0;
    sum += error_m;
    sum_sq += error_m * error_m;
  }
  const double variance = 0.02 * 0.02 + 1e-6 / 12;  // and the millimetre steps'
  EXPECT_NEAR(sum / kNum, 0.0, 4.5 * std::sqrt(variance / kNum));
  EXPECT_NEAR(sum_sq / kNum, variance, 4.5 * variance * std::sqrt(2.0 / kNum));
}

TEST(LmsModelTest, TheSameBeamGetsTheSameNoise) {
  const LmsModel model(with_sigma(0.1), 5);
  const LmsModel again(with_sigma(0.1), 5);
  const LmsModel other(with_sigma(0.1), 6);
  int num_different = 0;
  for (int beam = 360; beam >= 0; --beam) {
    EXPECT_EQ(model.measure(4.0, 3, beam), again.measure(4.0, 3, beam));
    num_different += model.measure(4.0, 3, beam) != other.measure(4.0, 3, beam);
  }
  EXPECT_GT(num_different, 340);  // 1 in 250 coincides by chance: steps of 1 mm under a sigma of 100 mm
}

TEST(LmsModelTest, NoiseNearTheEndsStaysAWord) {
  const LmsModel model(with_sigma(0.05), 1);
  int num_beyond = 0;
  int num_zero = 0;
  for (int beam = 0; beam < 1000; ++beam) {
    const std::uint16_t far = model.measure(8.1825, 0, beam);
    EXPECT_TRUE(far <= kLmsMaxSteps || far == kLmsBeyondMax);
    num_beyond += far == kLmsBeyondMax;
    num_zero += model.measure(0.0, 0, beam) == 0;
    EXPECT_EQ(model.measure(kNoEcho, 0, beam), kLmsNoStopSignal);
  }
  // Half of a symmetric distribution falls on either side; 4.5 standard deviations of a binomial, and the
  // half step that rounds to 0.
  EXPECT_NEAR(num_beyond, 500, 75);
  EXPECT_NEAR(num_zero, 500, 80);
}

}  // namespace
}  // namespace scanbed::sim
