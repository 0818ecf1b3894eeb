// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "core/detect/robust/arc_moments.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

constexpr double kAnyChi2 = std::numeric_limits<double>::infinity();

std::optional<ArcFit> fit_all(const LaserScan& scan, std::span<const Witness> witnesses = {}) {
  Echoes echoes;
  EchoReader().read(scan, {}, echoes);
  const Stretch all{0, echoes.size() - 1};
  ArcMoments moments;
  moments.begin(echoes);
  const auto start = moments.arc(all);
  if (!start) return std::nullopt;
  return fit_arc(echoes, {std::span(&all, 1), witnesses}, start->cylinder, kAnyChi2);
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
    EXPECT_NEAR((fit->cylinder.center_m - Eigen::Vector2d(radius_m + 2.0, 0.0)).norm(), 0.0, 1e-4);
    EXPECT_NEAR(fit->cylinder.radius_m, radius_m, 1e-4);
  }
}

TEST(ArcFitTest, TheErrorIsWhatItsCovarianceSays) {
  double sum = 0.0;
  constexpr int kRepeats = 200;
  for (int seed = 0; seed < kRepeats; ++seed) {
    const auto fit = fit_all(with_noise(column_scan(3.0, 0.25), 0.005, static_cast<unsigned>(seed)));
    ASSERT_TRUE(fit);
    const double error_m = fit->cylinder.radius_m - 0.25;
    sum += error_m * error_m / fit->information.inverse()(2, 2) / kRepeats;
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
    with_m2 += std::pow(held->cylinder.radius_m - 0.1, 2);
    without_m2 += std::pow(open->cylinder.radius_m - 0.1, 2);
  }
  EXPECT_LT(with_m2, 0.25 * without_m2);
}

TEST(ArcFitTest, AHollowHasNoArcEvenFromAStartBeforeIt) {
  LaserScan hollow;  // concave towards the sensor: all ranges alike, the centre is the sensor itself
  hollow.range_m.assign(361, 2.0);
  Echoes echoes;
  EchoReader().read(hollow, {}, echoes);
  const Stretch all{0, echoes.size() - 1};
  EXPECT_FALSE(fit_arc(echoes, {std::span(&all, 1), {}}, {{0.3, 0.0}, 1.7}, kAnyChi2));
}

TEST(ArcFitTest, TwoPartsOfAColumnAreFittedAsOne) {
  Echoes echoes;
  EchoReader().read(column_scan(3.0, 0.3), {}, echoes);
  const int last = echoes.size() - 1;
  ASSERT_GE(last, 9);
  for (const Stretch& hidden : {Stretch{4, 6}, Stretch{5, 5}}) {  // even and odd numbers of echoes
    const Stretch parts[] = {{0, hidden.first - 1}, {hidden.last + 1, last}};
    const auto fit = fit_arc(echoes, {parts, {}}, {{2.9, 0.1}, 0.2}, kAnyChi2);
    ASSERT_TRUE(fit);
    EXPECT_NEAR((fit->cylinder.center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 1e-4);
    EXPECT_NEAR(fit->cylinder.radius_m, 0.3, 1e-4);
  }
}

TEST(ArcFitTest, WhatLeavesFarTooMuchIsGivenUp) {
  IdealScene scene;  // no column, but something round enough to fit one: a post of four sides
  scene.wall({2.0, 0.3}, {1.7, 0.0});
  scene.wall({1.7, 0.0}, {2.0, -0.3});
  Echoes echoes;
  EchoReader().read(with_noise(scene.scan(), 0.003, 1), {}, echoes);
  const Stretch all{0, echoes.size() - 1};
  const Cylinder start{{2.1, 0.0}, 0.4};
  const auto fit = fit_arc(echoes, {std::span(&all, 1), {}}, start, kAnyChi2);
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit_arc(echoes, {std::span(&all, 1), {}}, start, 0.1 * fit->chi2));
  // As long as what it leaves is not too much, the fit is the same.
  const auto enough = fit_arc(echoes, {std::span(&all, 1), {}}, start, fit->chi2);
  ASSERT_TRUE(enough);
  EXPECT_EQ(enough->chi2, fit->chi2);
}

TEST(ArcFitTest, ChiSquaredIsThatOfItsResiduals) {
  // The last step is taken at its word: 0.1 is what it may promise at most.
  for (unsigned seed = 0; seed < 100; ++seed) {
    Echoes echoes;
    EchoReader().read(with_noise(column_scan(3.0, 0.25), 0.008, seed), {}, echoes);
    const Stretch all{0, echoes.size() - 1};
    const auto fit = fit_arc(echoes, {std::span(&all, 1), {}}, {{2.95, 0.05}, 0.3}, kAnyChi2);
    ASSERT_TRUE(fit);
    double chi2 = 0.0;
    for (int k = 0; k < echoes.size(); ++k) chi2 += fit->squared_residual(echoes, k);
    EXPECT_NEAR(fit->chi2, chi2, 0.1);
  }
}

TEST(ArcFitTest, ResidualsAreInUnitsOfTheirSigmaWhereTheSurfaceFacesTheSensor) {
  Echoes echoes;
  EchoReader().read(column_scan(3.0, 0.3), {}, echoes);
  const ArcFit fit{.cylinder = {{3.0, 0.0}, 0.3 + 2.0 * echoes.sigma_m(0)}};
  EXPECT_NEAR(fit.squared_residual(echoes, echoes.size() / 2), 4.0, 0.01);
  // At the silhouette errors along the beam count for less: at most 1 / 0.6 of what they are.
  EXPECT_GT(fit.squared_residual(echoes, 0), 4.0);
  EXPECT_LE(fit.squared_residual(echoes, 0), 4.0 / 0.36 + 1e-9);
}

}  // namespace
}  // namespace scanbed
