// SPDX-License-Identifier: MIT
#include "core/detect/robust/echoes.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

Echoes echoes_of(const LaserScan& scan, const SurfaceOptions& options = {}) {
  Echoes echoes;
  EchoReader().read(scan, options, echoes);
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

TEST(EchoReaderTest, EstimatesAsMuchNoiseAsItIsAllowedTo) {
  for (const double sigma_m : {0.03, 0.05, 0.08}) {
    const Echoes echoes = echoes_of(with_noise(room(), sigma_m, 7), {.max_noise_m = 0.12});
    EXPECT_NEAR(echoes.range_noise_m, 1.15 * sigma_m, 0.15 * sigma_m);
  }
}

// 10 mm a metre, on top of the 3 mm that are the least.
TEST(EchoReaderTest, NoiseMayGrowWithTheRange) {
  const SurfaceOptions options{.noise_ratio = 0.01};
  const Echoes echoes = echoes_of(room(), options);
  EXPECT_DOUBLE_EQ(echoes.range_noise_m, 0.003);
  for (int k = 0; k < echoes.size(); ++k) {
    EXPECT_GE(echoes.sigma_m(k), (1.0 - 1e-12) * std::hypot(0.003, 0.01 * echoes.range_m[k]));
  }
  EXPECT_DOUBLE_EQ(echoes.sigma_m(180), std::hypot(0.003, 0.03));  // head-on at 3 m
  EXPECT_DOUBLE_EQ(echoes.variance_at_m2(3.0), 0.003 * 0.003 + 0.03 * 0.03);
}

// What the scan shows beyond that is the sensor's own: 20 mm where the part that grows is 10 mm at 1 m.
TEST(EchoReaderTest, TheRestOfTheNoiseIsEstimated) {
  LaserScan scan;
  scan.range_m.assign(361, 1.0);
  const Echoes echoes = echoes_of(with_noise(scan, 0.02, 5), {.noise_ratio = 0.01});
  EXPECT_NEAR(echoes.range_noise_m, std::sqrt(1.15 * 1.15 * 0.02 * 0.02 - 0.01 * 0.01), 0.15 * 0.02);
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
  EXPECT_GT(echoes.sigma_m(3), 3.0 * echoes.range_noise_m);
  EXPECT_DOUBLE_EQ(echoes.sigma_m(echoes.size() - 5), echoes.range_noise_m);
}

TEST(EchoReaderTest, LeavesOutWhatHasNoRange) {
  LaserScan scan;
  scan.range_m = {kNoEcho, 1.0, kInvalid, 0.0, -1.0, kTooClose, 2.0};
  EXPECT_EQ(echoes_of(scan).beam, (std::vector<int>{1, 6}));
}

TEST(EchoReaderTest, PointsLieWhereTheirBeamsPoint) {
  LaserScan scan;
  scan.range_m = {2.0, kNoEcho, 3.0};
  const Echoes echoes = echoes_of(scan);
  for (int k = 0; k < 2; ++k) {
    const double bearing_rad = scan.geometry.bearing_rad(echoes.beam[k]);
    EXPECT_NEAR(echoes.x_m[k], echoes.range_m[k] * std::cos(bearing_rad), 1e-12);
    EXPECT_NEAR(echoes.y_m[k], echoes.range_m[k] * std::sin(bearing_rad), 1e-12);
  }
}

TEST(EchoReaderTest, AllInstructionSetsReadTheSameEchoesToTheBit) {
  IdealScene corridor;
  corridor.wall({-1.0, 1.0}, {30.0, 1.0});
  corridor.wall({2.0, -1.0}, {0.0, -9.0});
  LaserScan scan = with_noise(corridor.scan(), 0.01, 4);
  for (int i = 0; i < scan.num_beams(); i += 1 + i % 7) scan.range_m[i] = i % 2 == 0 ? kInvalid : kNoEcho;
  for (int num_beams = scan.num_beams(); num_beams >= 0; num_beams -= num_beams > 40 ? 29 : 1) {
    scan.range_m.resize(num_beams);
    Echoes plain;
    Echoes widest;
    EchoReader(InstructionSet::kPlain).read(scan, {}, plain);
    EchoReader().read(scan, {}, widest);
    EXPECT_EQ(plain.beam, widest.beam);
    EXPECT_EQ(plain.range_m, widest.range_m);
    EXPECT_EQ(plain.x_m, widest.x_m);
    EXPECT_EQ(plain.y_m, widest.y_m);
    EXPECT_EQ(plain.weight_per_m2, widest.weight_per_m2);
    EXPECT_EQ(plain.range_noise_m, widest.range_noise_m);
  }
}

// Ranges whose third differences all are 6 times the given value, and their steps small.
std::vector<double> cubic(double sixth_m, int num) {
  std::vector<double> range_m;
  for (int i = 0; i < num; ++i) {
    const double k = i - 0.5 * (num - 1);
    range_m.push_back(2.0 + sixth_m * k * k * k);
  }
  return range_m;
}

TEST(NoiseHistogramTest, TheMedianOfThirdDifferencesTellsSigma) {
  // Third differences of white noise of sigma s are Gaussian with sqrt(20) s, the median of their absolute
  // values 0.67449 of that.
  NoiseHistogram histogram;
  for (const double sigma_m : {0.0002, 0.0003, 0.0004}) {
    for (const int num : {16, 17}) {
      const auto found_m = histogram.sigma_m(cubic(0.67449 * std::sqrt(20.0) * sigma_m / 6.0, num), 0.03);
      ASSERT_TRUE(found_m);
      EXPECT_NEAR(*found_m, sigma_m, 0.00025 / 0.67449 / std::sqrt(20.0));  // a bin
    }
  }
}

TEST(NoiseHistogramTest, EdgesAndBeamsWithoutEchoAreNoNoise) {
  NoiseHistogram histogram;
  std::vector<double> range_m(40, 2.0);
  ASSERT_TRUE(histogram.sigma_m(range_m, 0.03));
  EXPECT_NEAR(*histogram.sigma_m(range_m, 0.03), 0.0, 1e-4);
  for (int i = 0; i < 40; i += 3) range_m[i] = 3.0;
  EXPECT_FALSE(histogram.sigma_m(range_m, 0.03));
  for (const double no_echo : {kNoEcho, kTooClose, kInvalid, 0.0}) {
    for (int i = 0; i < 40; i += 3) range_m[i] = no_echo;
    EXPECT_FALSE(histogram.sigma_m(range_m, 0.03));
  }
}

TEST(NoiseHistogramTest, TooFewRangesSayNothing) {
  NoiseHistogram histogram;
  for (const int num : {0, 1, 3, 14}) EXPECT_FALSE(histogram.sigma_m(std::vector<double>(num, 1.0), 0.03));
  EXPECT_TRUE(histogram.sigma_m(std::vector<double>(15, 1.0), 0.03));
}

}  // namespace
}  // namespace scanbed
