// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_fit.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

std::optional<ArcFit> fit_all(const LaserScan& scan, std::span<const Witness> witnesses = {}) {
  Echoes echoes;
  EchoReader().read(scan, {}, echoes);
  std::vector<int> members(echoes.size());
  std::iota(members.begin(), members.end(), 0);
  return fit_arc(echoes, members, witnesses);
}

LaserScan column_scan(double range_m, double radius_m) {
  IdealScene scene;
  scene.cylinder({range_m, 0.0}, radius_m);
  return scene.scan();
}

TEST(ArcFitTest, RecoversAnExactColumn) {
  for (const double radius_m : {0.05, 0.25, 1.0}) {
    const auto fit = fit_all(column_scan(radius_m + 2.0, radius_m));
    ASSERT_TRUE(fit) << radius_m;
    EXPECT_NEAR((fit->center_m - Eigen::Vector2d(radius_m + 2.0, 0.0)).norm(), 0.0, 1e-4);
    EXPECT_NEAR(fit->radius_m, radius_m, 1e-4);
  }
}

TEST(ArcFitTest, TheErrorIsWhatItsCovarianceSays) {
  double sum = 0.0;
  constexpr int kRepeats = 200;
  for (int seed = 0; seed < kRepeats; ++seed) {
    const auto fit = fit_all(with_noise(column_scan(3.0, 0.25), 0.005, static_cast<unsigned>(seed)));
    ASSERT_TRUE(fit);
    const double error_m = fit->radius_m - 0.25;
    sum += error_m * error_m / fit->covariance(2, 2) / kRepeats;
  }
  // The noise is inflated by 1.15 in sigma: 1 / 1.32 = 0.76, give or take the estimate's own spread.
  EXPECT_GT(sum, 0.4);
  EXPECT_LT(sum, 1.2);
}

TEST(ArcFitTest, WitnessesThatMissTheColumnHoldItsRadius) {
  // Seven echoes with 12 mm of noise leave a radius of 0.1 m wide open; the beams beside the column do not.
  const ScanGeometry geometry;
  double with_m2 = 0.0;
  double without_m2 = 0.0;
  for (int seed = 0; seed < 100; ++seed) {
    const LaserScan scan = with_noise(column_scan(3.0, 0.1), 0.012, static_cast<unsigned>(seed));
    int first = 0;
    while (!scan.has_echo(first)) ++first;
    int last = first;
    while (scan.has_echo(last + 1)) ++last;
    const auto witness = [&](int beam) {
      return Witness{std::cos(geometry.bearing_rad(beam)), std::sin(geometry.bearing_rad(beam))};
    };
    const Witness witnesses[] = {witness(first - 1), witness(last + 1)};
    const auto held = fit_all(scan, witnesses);
    const auto open = fit_all(scan);
    if (!held || !open) continue;
    with_m2 += std::pow(held->radius_m - 0.1, 2);
    without_m2 += std::pow(open->radius_m - 0.1, 2);
  }
  EXPECT_LT(with_m2, 0.25 * without_m2);
}

TEST(ArcFitTest, HollowsStraightRunsAndTooFewEchoesHaveNoArc) {
  IdealScene wall;
  wall.wall({2.0, -0.5}, {2.0, 0.5});
  EXPECT_FALSE(fit_all(wall.scan()));
  LaserScan hollow;  // concave towards the sensor: all ranges alike, the centre is the sensor itself
  hollow.range_m.assign(361, 2.0);
  EXPECT_FALSE(fit_all(hollow));
  LaserScan two;
  two.range_m = {1.0, 1.0};
  EXPECT_FALSE(fit_all(two));
}

}  // namespace
}  // namespace scanbed
