// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scanbed::bench {
namespace {

// At each of 13 sums as many legs of 10000 as the curve says, to the nearest.
std::vector<JudgedSum> drawn_from(const Logistic& logistic, double greatest_sum = 3.0) {
  constexpr int kNumEach = 10000;
  std::vector<JudgedSum> judged;
  for (int k = -6; k <= 6; ++k) {
    const double sum = greatest_sum * k / 6.0;
    const double p = 1.0 / (1.0 + std::exp(-(logistic.slope * sum + logistic.offset)));
    const auto num_legs = static_cast<int>(std::lround(kNumEach * p));
    for (int i = 0; i < kNumEach; ++i) judged.push_back({sum, i < num_legs});
  }
  return judged;
}

TEST(LegCalibrationTest, RecoversTheCurveThatTheAnswersWereDrawnFrom) {
  for (const Logistic& logistic : {Logistic{1.0, 0.0}, Logistic{0.7, -1.2}, Logistic{1.6, 0.4}}) {
    const Logistic fitted = fit_logistic(drawn_from(logistic));
    // Rounding to a 10000th moves the curve no more.
    EXPECT_NEAR(fitted.slope, logistic.slope, 1e-3);
    EXPECT_NEAR(fitted.offset, logistic.offset, 1e-3);
  }
}

// Where most answers are certain, whole steps of Newton's method overshoot.
TEST(LegCalibrationTest, RecoversTheCurveOfSumsThatAreNearlyCertain) {
  const Logistic logistic{0.5, -1.0};
  const Logistic fitted = fit_logistic(drawn_from(logistic, 30.0));
  EXPECT_NEAR(fitted.slope, logistic.slope, 1e-2);
  EXPECT_NEAR(fitted.offset, logistic.offset, 2e-2);
}

TEST(LegCalibrationTest, SumsThatSayNothingLeaveTheShareOfLegs) {
  std::vector<JudgedSum> judged;
  for (const double sum : {-1.0, 1.0}) {
    for (int i = 0; i < 4; ++i) judged.push_back({sum, i == 0});
  }
  const Logistic fitted = fit_logistic(judged);
  EXPECT_NEAR(fitted.slope, 0.0, 1e-6);
  EXPECT_NEAR(fitted.offset, std::log(1.0 / 3.0), 1e-6);
}

TEST(LegCalibrationTest, TheBoundLosesNoMoreThanItsShare) {
  std::vector<float> sums;
  for (int i = 0; i < 1000; ++i) sums.push_back(static_cast<float>((i * 389) % 1000));  // each once
  for (const double share : {0.0, 0.002, 0.1, 0.999}) {
    const float bound = bound_that_loses(share, sums);
    const auto num_lost = std::count_if(sums.begin(), sums.end(), [&](float sum) { return sum < bound; });
    EXPECT_LE(static_cast<double>(num_lost), share * 1000.0);
    EXPECT_GT(static_cast<double>(num_lost), share * 1000.0 - 1.0);
  }
}

TEST(LegCalibrationTest, TheBoundOfOneSumIsThatSum) {
  EXPECT_EQ(bound_that_loses(0.002, {-1.5F}), -1.5F);
}

}  // namespace
}  // namespace scanbed::bench
