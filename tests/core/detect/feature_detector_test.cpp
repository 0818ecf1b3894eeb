// SPDX-License-Identifier: MIT
#include "core/detect/feature_detector.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/detect/table_two.hpp"
#include "core/errors/input_error.hpp"
#include "tests/support/ideal_scene.hpp"
#include "tests/support/scan_of.hpp"

namespace scanbed {
namespace {

using Eigen::Vector2d;
using testing::IdealScene;
using testing::scan_of;
using testing::with_noise;

bool is_empty(const Features& f) {
  return f.lines.empty() && f.circles.empty() && f.legs.empty();
}

TEST(FeatureDetectorTest, FindsTheWallsTheColumnAndTheLegOfAHall) {
  IdealScene hall;
  hall.wall({-1.0, -3.0}, {5.0, -3.0});
  hall.wall({5.0, -3.0}, {5.0, 3.0});
  hall.wall({5.0, 3.0}, {-1.0, 3.0});
  hall.cylinder({3.0, 1.0}, 0.25);
  hall.cylinder({2.0, -0.5}, 0.07, Primitive::kLeg);
  FeatureDetector detector(paper_options());
  const Features& features = detector.detect(with_noise(hall.scan(), 0.002, 3));
  ASSERT_EQ(features.circles.size(), 1u);
  // Two end points carry the whole estimate; the gate of the scores is 0.10 m.
  EXPECT_NEAR((features.circles[0].center_m - Eigen::Vector2d(3.0, 1.0)).norm(), 0.0, 0.10);
  ASSERT_EQ(features.legs.size(), 1u);
  EXPECT_NEAR((features.legs[0].middle_m - Eigen::Vector2d(2.0, -0.5)).norm(), 0.07, 0.02);
  EXPECT_GE(features.lines.size(), 3u);
}

TEST(FeatureDetectorTest, CirclesComeFirstSoThatLinesMakeNoPolygonsOfThem) {
  IdealScene scene;
  scene.cylinder({3.0, 0.0}, 0.5);
  const LaserScan scan = scene.scan();
  FeatureDetector detector(paper_options());
  EXPECT_TRUE(detector.detect(scan).lines.empty());
  DetectorOptions no_circles = paper_options();
  set_table_two(no_circles, "circles", 0);
  EXPECT_FALSE(FeatureDetector(no_circles).detect(scan).lines.empty());
}

// A wedge that points at the sensor: walls at 60 degrees to each other, joined by an arc of radius 1 m and
// 120 degrees. (The arc of a right-angled corner has inscribed angles of 135 degrees and more: the paper's
// limit leaves it out.)
LaserScan round_corner() {
  const Eigen::Vector2d center_m(3.0, 0.0);
  const Eigen::Vector2d right_m = center_m + Eigen::Vector2d(std::cos(radians(240)), std::sin(radians(240)));
  const Eigen::Vector2d along(std::cos(radians(-30)), std::sin(radians(-30)));  // tangent at right_m
  IdealScene walls;
  walls.wall(right_m, right_m + 2.0 * along);
  walls.wall({right_m.x(), -right_m.y()}, {right_m.x() + 2.0 * along.x(), -right_m.y() - 2.0 * along.y()});
  LaserScan scan = walls.scan();
  IdealScene arc_alone;
  arc_alone.cylinder(center_m, 1.0);
  const LaserScan arc = arc_alone.scan();
  for (int i = 0; i < scan.num_beams(); ++i) scan.range_m[i] = std::min(scan.range_m[i], arc.range_m[i]);
  return scan;
}

TEST(FeatureDetectorTest, FindsArcsEmbeddedInLinesWithoutSmallPolygons) {
  DetectorOptions options = paper_options();
  set_table_two(options, "seg_threshold", 400);  // the wedge's walls are seen at grazing incidence
  set_table_two(options, "line_err", 0.005);
  set_table_two(options, "line_min_len", 600);
  FeatureDetector detector(options);
  const Features& found = detector.detect(round_corner());
  EXPECT_EQ(found.lines.size(), 2u);
  ASSERT_EQ(found.circles.size(), 1u);
  EXPECT_NEAR((found.circles[0].center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 0.02);
  EXPECT_NEAR(found.circles[0].radius_m, 1.0, 0.02);
  options.circle.in_lines = false;
  EXPECT_TRUE(FeatureDetector(options).detect(round_corner()).circles.empty());
}

TEST(FeatureDetectorTest, ScansOfZeroOneOrTwoBeamsHoldNothing) {
  FeatureDetector detector(paper_options());
  for (const auto& ranges : {std::vector<double>{}, {1.0}, {1.0, 1.0}}) {
    EXPECT_TRUE(is_empty(detector.detect(scan_of(ranges)))) << ranges.size();
  }
}

TEST(FeatureDetectorTest, ScansWithoutEchoesHoldNothing) {
  FeatureDetector detector(paper_options());
  for (const double range_m : {kInvalid, kNoEcho, kTooClose, 0.0}) {
    EXPECT_TRUE(is_empty(detector.detect(scan_of(std::vector<double>(361, range_m))))) << range_m;
  }
}

TEST(FeatureDetectorTest, HugeScansAndHugeRangesAreFine) {
  FeatureDetector detector(paper_options());
  LaserScan scan = scan_of(std::vector<double>(10000, 2.0));
  scan.geometry.step_rad = 2 * kPi / 10000;
  EXPECT_NO_THROW(detector.detect(scan));
  EXPECT_NO_THROW(detector.detect(scan_of(std::vector<double>(361, 1e300))));
}

TEST(FeatureDetectorTest, RefusesOptionsThatDoNotValidate) {
  DetectorOptions options = paper_options();
  options.line.max_error_m = -1.0;
  EXPECT_THROW(FeatureDetector{options}, InputError);
}

TEST(FeatureDetectorTest, ASensorThatTurnsClockwiseSeesTheSame) {
  IdealScene scene;
  scene.cylinder({3.0, 0.7}, 0.3);
  scene.wall({1.0, -3.0}, {5.0, -2.0});
  const LaserScan scan = scene.scan();
  LaserScan clockwise = scan;
  std::reverse(clockwise.range_m.begin(), clockwise.range_m.end());
  clockwise.geometry.first_rad = -scan.geometry.first_rad;
  clockwise.geometry.step_rad = -scan.geometry.step_rad;
  FeatureDetector one(paper_options());
  FeatureDetector other(paper_options());
  const Features& a = one.detect(scan);
  const Features& b = other.detect(clockwise);
  ASSERT_EQ(a.circles.size(), 1u);
  ASSERT_EQ(b.circles.size(), 1u);
  EXPECT_NEAR((a.circles[0].center_m - b.circles[0].center_m).norm(), 0.0, 1e-9);
  ASSERT_EQ(a.lines.size(), 1u);
  ASSERT_EQ(b.lines.size(), 1u);
  EXPECT_NEAR((a.lines[0].left_m - b.lines[0].right_m).norm(), 0.0, 1e-9);
}

/// The mean of squared errors over what the covariances say, divided by the degrees of freedom.
struct Consistency {
  double of_lines = 0.0;
  double of_circles = 0.0;
};

Consistency consistency(const ScanGeometry& geometry, double sigma_m) {
  const Vector2d center_m(-1.5, 1.0);
  IdealScene scene(geometry);
  scene.wall({4.0, -3.0}, {2.0, 3.0});
  scene.cylinder(center_m, 0.25);
  const LaserScan ideal = scene.scan();
  // The wall's normal and distance.
  const double bearing_rad = std::atan2(1.0, 3.0);
  const double distance_m = 4.0 * std::cos(bearing_rad) - 3.0 * std::sin(bearing_rad);
  FeatureDetector detector(robust_options());
  Consistency mean;
  int num_lines = 0;
  int num_circles = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Features& found = detector.detect(with_noise(ideal, sigma_m, seed));
    for (const Line& line : found.lines) {
      const Vector2d along = (line.right_m - line.left_m).normalized();
      const Vector2d normal = line.left_m.dot(Vector2d(-along.y(), along.x())) < 0.0
                                  ? Vector2d(along.y(), -along.x())
                                  : Vector2d(-along.y(), along.x());
      const Vector2d error(std::atan2(normal.y(), normal.x()) - bearing_rad,
                           line.left_m.dot(normal) - distance_m);
      mean.of_lines += error.dot(line.covariance.value().inverse() * error) / 2.0;
      ++num_lines;
    }
    for (const Circle& circle : found.circles) {
      Eigen::Vector3d error;
      error << circle.center_m - center_m, circle.radius_m - 0.25;
      mean.of_circles += error.dot(circle.covariance.value().inverse() * error) / 3.0;
      ++num_circles;
    }
  }
  EXPECT_NEAR(num_lines, 300, 6);
  EXPECT_NEAR(num_circles, 300, 6);
  mean.of_lines /= num_lines;
  mean.of_circles /= num_circles;
  return mean;
}

// Sigma is taken for 1.15 times as large as it looks, so that 0.76 is to be expected; a mean of 300 with two
// degrees of freedom errs by 6 %. A silhouette is no Gaussian.
TEST(FeatureDetectorTest, ErrorsAreWhatTheCovariancesSay) {
  constexpr ScanGeometry kAllAround{.num_beams = 720, .first_rad = -kPi, .step_rad = radians(0.5)};
  constexpr ScanGeometry kFromElsewhere{.num_beams = 720, .first_rad = 2.0, .step_rad = radians(0.5)};
  constexpr ScanGeometry kClockwise{.num_beams = 700, .first_rad = kPi, .step_rad = -radians(0.5)};
  for (const ScanGeometry& geometry : {kAllAround, kFromElsewhere, kClockwise}) {
    for (const double sigma_m : {0.005, 0.012, 0.02}) {
      const Consistency mean = consistency(geometry, sigma_m);
      EXPECT_GT(mean.of_lines, 0.6) << sigma_m;
      EXPECT_LT(mean.of_lines, 1.1) << sigma_m;
      EXPECT_GT(mean.of_circles, 0.4) << sigma_m;
      EXPECT_LT(mean.of_circles, 1.2) << sigma_m;
    }
  }
}

TEST(FeatureDetectorTest, ThePapersFeaturesHaveNoCovariance) {
  IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 2.0});
  scene.cylinder({1.5, 0.0}, 0.25);
  FeatureDetector detector(paper_options());
  const Features& found = detector.detect(scene.scan());
  ASSERT_FALSE(found.lines.empty() || found.circles.empty());
  EXPECT_FALSE(found.lines[0].covariance || found.circles[0].covariance);
}

TEST(FeatureDetectorTest, OptionsChangeBetweenScans) {
  testing::IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 2.0});
  scene.cylinder({2.0, 1.0}, 0.2);
  const LaserScan scan = scene.scan();
  FeatureDetector detector(robust_options());
  for (const DetectorOptions& options : {paper_options(), robust_options(), paper_options()}) {
    detector.set_options(options);
    FeatureDetector fresh(options);
    const Features& changed = detector.detect(scan);
    const Features& expected = fresh.detect(scan);
    ASSERT_EQ(changed.lines.size(), expected.lines.size());
    ASSERT_EQ(changed.circles.size(), expected.circles.size());
    for (std::size_t i = 0; i < expected.circles.size(); ++i) {
      EXPECT_EQ(changed.circles[i].radius_m, expected.circles[i].radius_m);
    }
  }
  DetectorOptions bad = robust_options();
  bad.surface.arc_price = -1.0;
  EXPECT_THROW(detector.set_options(bad), InputError);
  EXPECT_EQ(detector.options().pipeline, Pipeline::kPaper);
}

}  // namespace
}  // namespace scanbed
