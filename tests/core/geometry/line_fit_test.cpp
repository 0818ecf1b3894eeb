// SPDX-License-Identifier: MIT
#include "core/geometry/line_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <vector>

#include "core/geometry/angles.hpp"

namespace scanbed {
namespace {

LineMoments moments_of(const std::vector<Eigen::Vector2d>& points_m) {
  LineMoments moments;
  for (const auto& p_m : points_m) moments.add(p_m.x(), p_m.y());
  return moments;
}

double sine_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(a.x() * b.y() - a.y() * b.x());
}

TEST(LineFitTest, RecoversExactLinesInEveryDirection) {
  for (int deg = 0; deg < 180; deg += 15) {
    const Eigen::Vector2d direction(std::cos(radians(deg)), std::sin(radians(deg)));
    const LineFit fit = fit_line(moments_of({direction * -1.0, direction * 0.5, direction * 2.0}));
    EXPECT_NEAR(sine_between(fit.direction, direction), 0.0, 1e-12) << deg;
    EXPECT_NEAR(fit.distance_m(direction * 7.0), 0.0, 1e-12) << deg;
  }
}

TEST(LineFitTest, AgreesWithTheEigenvectorOfTheScatterMatrix) {
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal;
  for (int repeat = 0; repeat < 100; ++repeat) {
    std::vector<Eigen::Vector2d> points_m;
    LineMoments moments;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (int i = 0; i < 20; ++i) {
      points_m.emplace_back(3.0 * normal(engine), normal(engine));
      moments.add(points_m.back().x(), points_m.back().y());
      mean += points_m.back() / 20.0;
    }
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& p : points_m) scatter += (p - mean) * (p - mean).transpose();
    const auto solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>().computeDirect(scatter);
    EXPECT_NEAR(sine_between(fit_line(moments).direction, solver.eigenvectors().col(1)), 0.0, 1e-9);
  }
}

TEST(LineFitTest, DifferencesOfRunningSumsFitThePointsInBetween) {
  LineMoments before;
  before.add(100.0, -3.0);
  LineMoments after = before;
  for (int i = 0; i < 5; ++i) after.add(i, 2.0 * i + 1.0);
  const LineFit fit = fit_line(after - before);
  EXPECT_NEAR(fit.direction.y() / fit.direction.x(), 2.0, 1e-9);
  EXPECT_NEAR(fit.distance_m({0.0, 1.0}), 0.0, 1e-9);
}

TEST(LineFitTest, FootIsTheNearestPointOfTheLine) {
  const LineFit fit = fit_line(moments_of({{0.0, 0.0}, {4.0, 0.0}}));
  EXPECT_NEAR((fit.foot_of({1.0, 5.0}) - Eigen::Vector2d(1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(fit.distance_m({1.0, 5.0}), 5.0, 1e-12);
}

TEST(LineFitTest, PointsThatCoincideGiveAFiniteDirection) {
  const LineFit fit = fit_line(moments_of({{1.0, 1.0}, {1.0, 1.0}}));
  EXPECT_DOUBLE_EQ(fit.direction.norm(), 1.0);
}

}  // namespace
}  // namespace scanbed
