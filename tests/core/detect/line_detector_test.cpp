// SPDX-License-Identifier: MIT
#include "core/detect/line_detector.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "tests/support/arc_points.hpp"

namespace scanbed {
namespace {

using testing::all_of;
using testing::append;

std::vector<Line> lines_of(const Points& points, const LineOptions& options = {}) {
  std::vector<Line> lines;
  LineDetector(options).detect(points, all_of(points), lines);
  return lines;
}

/// Points every `step_m` along a polyline; corners are points.
Points polyline(const std::vector<Eigen::Vector2d>& corners_m, double step_m) {
  Points points;
  append(points, corners_m.front());
  for (std::size_t i = 1; i < corners_m.size(); ++i) {
    const Eigen::Vector2d edge_m = corners_m[i] - corners_m[i - 1];
    const int num_steps = static_cast<int>(std::lround(edge_m.norm() / step_m));
    for (int k = 1; k <= num_steps; ++k) append(points, corners_m[i - 1] + edge_m * k / num_steps);
  }
  return points;
}

TEST(LineDetectorTest, AWallGivesTableOnesFields) {
  const auto lines = lines_of(polyline({{1.0, 2.0}, {3.0, 3.0}}, 0.05));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].beams.first, 0);
  EXPECT_EQ(lines[0].beams.last, 45);
  EXPECT_EQ(lines[0].num_points, 46);
  EXPECT_NEAR((lines[0].left_m - Eigen::Vector2d(1.0, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((lines[0].right_m - Eigen::Vector2d(3.0, 3.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(lines[0].slope.value(), 0.5, 1e-9);
  EXPECT_NEAR(lines[0].bias_m.value(), 1.5, 1e-9);
  EXPECT_NEAR(lines[0].error_m, 0.0, 1e-9);
}

TEST(LineDetectorTest, ALineAlongYHasNoSlope) {
  const auto lines = lines_of(polyline({{2.0, -1.0}, {2.0, 1.0}}, 0.05));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].slope);
  EXPECT_FALSE(lines[0].bias_m);
}

TEST(LineDetectorTest, ACornerGivesTwoLinesThatShareItsPoint) {
  const auto lines = lines_of(polyline({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}, 0.05));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].beams.last, 40);
  EXPECT_EQ(lines[1].beams.first, 40);
}

TEST(LineDetectorTest, AStaircaseGivesALineForEachTread) {
  // Steps of 0.5 m: well above the allowed 0.1 m of error.
  const auto lines = lines_of(polyline({{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {2, 1}, {3, 1}}, 0.05));
  EXPECT_EQ(lines.size(), 5u);
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_EQ(lines[i].beams.first, lines[i - 1].beams.last);
}

TEST(LineDetectorTest, SplitsWhereAPointLiesFartherThanTheAllowedError) {
  // A shallow corner: 1 m legs and a sagitta h. The regression through two such legs leaves 2/3 h at most...
  // so test both sides of the allowed error generously.
  EXPECT_EQ(lines_of(polyline({{0, 0}, {1, 0.05}, {2, 0}}, 0.05)).size(), 1u);
  EXPECT_EQ(lines_of(polyline({{0, 0}, {1, 0.4}, {2, 0}}, 0.05)).size(), 2u);
  EXPECT_EQ(lines_of(polyline({{0, 0}, {1, 0.05}, {2, 0}}, 0.05), {.max_error_m = 0.02}).size(), 2u);
}

TEST(LineDetectorTest, RunsWithTooFewPointsOrTooShortAreDropped) {
  EXPECT_TRUE(lines_of(polyline({{0, 0}, {0.9, 0}}, 0.3)).empty());     // 4 points
  EXPECT_EQ(lines_of(polyline({{0, 0}, {1.2, 0}}, 0.3)).size(), 1u);    // 5
  EXPECT_TRUE(lines_of(polyline({{0, 0}, {0.14, 0}}, 0.01)).empty());   // 0.14 m
  EXPECT_EQ(lines_of(polyline({{0, 0}, {0.16, 0}}, 0.01)).size(), 1u);  // 0.16 m
  EXPECT_TRUE(lines_of({}).empty());
}

TEST(LineDetectorTest, OffMeansOff) {
  EXPECT_TRUE(lines_of(polyline({{0, 0}, {2, 0}}, 0.05), {.method = LineMethod::kOff}).empty());
}

TEST(LineDetectorTest, InscribedAnglesOf180DegreesFindWallsAndCorners) {
  const LineOptions iav{.method = LineMethod::kInscribedAngle};
  EXPECT_EQ(lines_of(polyline({{0, 0}, {2, 0}}, 0.05), iav).size(), 1u);
  const auto corner = lines_of(polyline({{0, 0}, {2, 0}, {2, 1}}, 0.05), iav);
  ASSERT_EQ(corner.size(), 2u);
  EXPECT_EQ(corner[1].beams.first, 40);
}

TEST(LineDetectorTest, SurvivesPointsThatCoincideAndRunsThatClose) {
  Points points;
  for (int i = 0; i < 50; ++i) append(points, {1.0, 1.0});
  EXPECT_TRUE(lines_of(points).empty());
  // A closed run: the distance between its extremes is below the least length, the paper's break condition.
  EXPECT_TRUE(lines_of(polyline({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, 0.05)).empty());
}

TEST(LineDetectorTest, NoisyWallIsFittedWithinItsStatisticalError) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> noise_m(0.0, 0.005);
  Points points = polyline({{2.0, -1.0}, {2.0, 1.0}}, 0.02);
  for (double& x_m : points.x_m) x_m += noise_m(engine);
  const auto lines = lines_of(points);
  ASSERT_EQ(lines.size(), 1u);
  // 4 sigma of a line's direction: sigma / sqrt(sum of squared positions along it); 101 points over 2 m
  // give 34.3 m2.
  const Eigen::Vector2d direction = (lines[0].right_m - lines[0].left_m).normalized();
  EXPECT_LT(std::abs(direction.x()), 4.0 * 0.005 / std::sqrt(34.3));
}

RC_GTEST_PROP(LineDetectorTest, LinesRiseDoNotOverlapAndKeepTheirPromises, (const std::vector<int>& ys_cm)) {
  Points points;
  for (std::size_t i = 0; i < ys_cm.size(); ++i)
    append(points, {0.05 * static_cast<double>(i), (ys_cm[i] % 60) / 100.0});
  RC_PRE(!ys_cm.empty());
  const LineOptions options;
  int last = 0;
  for (const Line& line : lines_of(points, options)) {
    RC_ASSERT(line.beams.first >= last);
    last = line.beams.last;
    RC_ASSERT(line.num_points >= options.min_points);
    RC_ASSERT(line.error_m <= options.max_error_m);
    RC_ASSERT((points[line.beams.last] - points[line.beams.first]).norm() >= options.min_length_m);
    RC_ASSERT(line.score >= 0.0 && line.score <= 1.0);
  }
}

}  // namespace
}  // namespace scanbed
