// SPDX-License-Identifier: MIT
#include "core/detect/robust/echoes.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

Echoes echoes_of(const LaserScan& scan) {
  Echoes echoes;
  EchoReader().read(scan, {}, echoes);
  return echoes;
}

LaserScan room() {
  IdealScene scene;
  scene.wall({-0.5, -2.0}, {3.0, -2.0});
  scene.wall({3.0, -2.0}, {3.0, 2.0});
  scene.wall({3.0, 2.0}, {-0.5, 2.0});
  return scene.scan();
}

TEST(EchoReaderTest, EstimatesTheNoiseOfTheScan) {
  for (const double sigma_m : {0.005, 0.012}) {
    // Inflated by 1.15 on purpose. Some 300 correlated differences: the median's own error is below 10 %.
    const double estimate_m = echoes_of(with_noise(room(), sigma_m, 7)).range_noise_m;
    EXPECT_NEAR(estimate_m, 1.15 * sigma_m, 0.15 * sigma_m);
  }
}

TEST(EchoReaderTest, TooFewEchoesGetADefaultNoise) {
  LaserScan scan;
  scan.range_m = {1.0, 1.0, 1.0};
  EXPECT_GT(echoes_of(scan).range_noise_m, 0.0);
  EXPECT_EQ(echoes_of({}).size(), 0);
}

TEST(EchoReaderTest, GrazingEchoesHaveALargerSigmaThanOthers) {
  IdealScene corridor;
  corridor.wall({-1.0, 1.0}, {30.0, 1.0});
  const Echoes echoes = echoes_of(with_noise(corridor.scan(), 0.005, 3));
  // Far down the corridor a beam step is a long way along the wall; beside the sensor it is nothing.
  EXPECT_GT(echoes.sigma_m[3], 3.0 * echoes.range_noise_m);
  EXPECT_DOUBLE_EQ(echoes.sigma_m[echoes.size() - 5], echoes.range_noise_m);
}

TEST(EchoReaderTest, LeavesOutWhatHasNoRange) {
  LaserScan scan;
  scan.range_m = {kNoEcho, 1.0, kInvalid, 0.0, -1.0, kTooClose, 2.0};
  EXPECT_EQ(echoes_of(scan).beam, (std::vector<int>{1, 6}));
}

TEST(NoiseHistogramTest, GivesTheSigmaOfWhiteNoise) {
  // Third differences of white noise of sigma s are Gaussian with sqrt(20) s; their quantiles in closed form.
  NoiseHistogram histogram;
  constexpr int kNum = 999;
  const double sigma_m = 0.007;
  // The quartiles of a Gaussian lie at 0.67449 of its sigma: half of all values within.
  for (int i = 0; i < kNum; ++i) histogram.add(0.67449 * std::sqrt(20.0) * sigma_m * 2.0 * i / (kNum - 1));
  ASSERT_TRUE(histogram.sigma_m());
  EXPECT_NEAR(*histogram.sigma_m(), sigma_m, 2e-4);
  histogram.clear();
  EXPECT_FALSE(histogram.sigma_m());
  for (int i = 0; i < 20; ++i) histogram.add(1e6);  // beyond the last bin
  EXPECT_GT(*histogram.sigma_m(), 0.03);
}

}  // namespace
}  // namespace scanbed
