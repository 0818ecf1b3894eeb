// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

struct Fitted {
  Echoes echoes;
  RayLine line;
};

Fitted fit_all(const LaserScan& scan) {
  Fitted fitted;
  EchoReader().read(scan, {}, fitted.echoes);
  RayLineSums sums;
  sums.build(fitted.echoes);
  fitted.line = sums.fit({0, fitted.echoes.size() - 1});
  return fitted;
}

LaserScan wall_scan() {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {3.0, 1.5});
  return scene.scan();
}

TEST(RayLineTest, AnExactWallHasItsNormalOverItsDistanceAndNoResidual) {
  const RayLine line = fit_all(wall_scan()).line;
  // Through (2, -1) along (1, 2.5): normal (2.5, -1), offset 6.
  EXPECT_NEAR(line.inverse_m.x(), 2.5 / 6.0, 1e-9);
  EXPECT_NEAR(line.inverse_m.y(), -1.0 / 6.0, 1e-9);
  EXPECT_NEAR(line.chi2, 0.0, 1e-4);
}

TEST(RayLineTest, NoiseLeavesAChiSquaredOfItsDegreesOfFreedom) {
  double ratio = 0.0;
  constexpr int kRepeats = 50;
  for (int seed = 0; seed < kRepeats; ++seed) {
    Fitted fitted = fit_all(with_noise(wall_scan(), 0.006, static_cast<unsigned>(seed)));
    const double true_sigmas = fitted.echoes.range_noise_m / 0.006;
    ratio += fitted.line.chi2 * true_sigmas * true_sigmas / (fitted.echoes.size() - 2) / kRepeats;
  }
  EXPECT_NEAR(ratio, 1.0, 0.1);  // 50 runs of some 110 echoes: 4 sigma are 0.08
}

TEST(RayLineTest, WhatTwoLinesExplainIsWhatTheyDoNotLeave) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.5, 1.0});
  Echoes echoes;
  EchoReader().read(with_noise(scene.scan(), 0.005, 4), {}, echoes);
  RayLineSums sums;
  sums.build(echoes);
  const int last = echoes.size() - 1;
  double all = 0.0;
  for (int k = 0; k <= last; ++k) all += echoes.range_m[k] * echoes.range_m[k] * echoes.weight_per_m2[k];
  for (const int split : {1, 20, last - 2}) {
    const double left = sums.fit({0, split}).chi2 + sums.fit({split + 1, last}).chi2;
    EXPECT_NEAR(sums.explained_by_two({0, last}, split), all - left, 1e-9 * all);
  }
  // One echo is explained wholly.
  EXPECT_NEAR(sums.explained_by_two({0, last}, 0), all - sums.fit({1, last}).chi2, 1e-9 * all);
  EXPECT_NEAR(sums.explained_by_two({0, last}, last - 1), all - sums.fit({0, last - 1}).chi2, 1e-9 * all);
}

TEST(RayLineTest, TwoStretchesAreFittedAsOne) {
  const Fitted whole = fit_all(with_noise(wall_scan(), 0.005, 4));
  RayLineSums sums;
  sums.build(whole.echoes);
  const double chi2 = sums.fit_both({0, 9}, {10, whole.echoes.size() - 1}).chi2;
  EXPECT_NEAR(chi2, whole.line.chi2, 1e-6 * chi2);
}

}  // namespace
}  // namespace scanbed
