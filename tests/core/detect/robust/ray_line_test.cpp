// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <gtest/gtest.h>

#include <numeric>

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
  std::vector<int> order(fitted.echoes.size());
  std::iota(order.begin(), order.end(), 0);
  RayLineSums sums;
  sums.build(fitted.echoes, order);
  fitted.line = sums.fit(0, fitted.echoes.size() - 1);
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

TEST(RayLineTest, ChiSquaredAloneIsThatOfTheFit) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.5, 1.0});
  Echoes echoes;
  EchoReader().read(with_noise(scene.scan(), 0.005, 4), {}, echoes);
  std::vector<int> order(echoes.size());
  std::iota(order.begin(), order.end(), 0);
  RayLineSums sums;
  sums.build(echoes, order);
  for (const Stretch places : {Stretch{0, echoes.size() - 1}, Stretch{3, 20}}) {
    const double expected = sums.fit(places.first, places.last).chi2;
    EXPECT_NEAR(sums.chi2(places.first, places.last), expected, 1e-6 * expected);
  }
  const double whole = sums.fit(0, echoes.size() - 1).chi2;
  EXPECT_NEAR(sums.fit_both({0, 9}, {10, echoes.size() - 1}).chi2, whole, 1e-6 * whole);
}

}  // namespace
}  // namespace scanbed
