// SPDX-License-Identifier: MIT
#include "bench/results/score_bins.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed::bench {
namespace {

TEST(ScoreBinsTest, EachScoreHasItsBin) {
  ScoreBins bins;
  bins.add(0.0, false);
  bins.add(0.09, true);
  bins.add(0.85, true);
  bins.add(0.95, true);
  bins.add(1.0, true);
  EXPECT_EQ(bins[0].whole, 2);
  EXPECT_EQ(bins[0].part, 1);
  EXPECT_EQ(bins[8].whole, 1);
  EXPECT_EQ(bins[9].whole, 2);
  EXPECT_EQ(bins[9].part, 2);
  for (int bin = 1; bin < 8; ++bin) EXPECT_EQ(bins[bin].whole, 0);
}

TEST(ScoreBinsTest, SumsAddBinByBin) {
  ScoreBins a;
  a.add(0.45, true);
  ScoreBins b;
  b.add(0.45, false);
  b.add(0.75, true);
  a += b;
  EXPECT_EQ(a[4].whole, 2);
  EXPECT_EQ(a[4].part, 1);
  EXPECT_EQ(a[7].whole, 1);
}

// The ends of Wilson's interval are the shares p that lie z of their own deviations from what was drawn:
// (p - part / whole)^2 = z^2 p (1 - p) / whole.
TEST(ScoreBinsTest, WilsonsEndsLieTwoDeviationsFromWhatWasDrawn) {
  for (const Share& share : {Share{8, 10}, Share{1, 7}, Share{950, 1000}}) {
    const Estimate estimate = wilson_interval(share);
    const double n = share.whole;
    EXPECT_DOUBLE_EQ(estimate.value, share.part / n);
    for (const double end : {estimate.low, estimate.high}) {
      EXPECT_NEAR(std::abs(end - estimate.value) / std::sqrt(end * (1.0 - end) / n), 1.96, 1e-3);
    }
    EXPECT_LT(estimate.low, estimate.value);
    EXPECT_GT(estimate.high, estimate.value);
  }
}

TEST(ScoreBinsTest, WilsonsIntervalStaysWithinZeroAndOne) {
  EXPECT_EQ(wilson_interval({0, 5}).low, 0.0);
  EXPECT_LT(wilson_interval({0, 5}).high, 1.0);
  EXPECT_EQ(wilson_interval({5, 5}).high, 1.0);
  EXPECT_GT(wilson_interval({5, 5}).low, 0.0);
  EXPECT_EQ(wilson_interval({}).low, 0.0);
  EXPECT_EQ(wilson_interval({}).high, 1.0);
}

}  // namespace
}  // namespace scanbed::bench
