// SPDX-License-Identifier: MIT
#include "core/detect/leg/forest_leg_detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/detect/feature_detector.hpp"
#include "tests/support/ideal_scene.hpp"
#include "tests/support/scan_of.hpp"

namespace scanbed {
namespace {

using Eigen::Vector2d;
using testing::IdealScene;
using testing::scan_of;

Features surfaces_in(const LaserScan& scan) {
  DetectorOptions options = robust_options();
  options.leg.enabled = false;
  return FeatureDetector(options).detect(scan);
}

Features detect_legs(const LaserScan& scan, const LegOptions& options) {
  Features features;
  ForestLegDetector(trained_leg_forest()).detect(scan, surfaces_in(scan), options, features);
  return features;
}

std::vector<Leg> legs_in(const LaserScan& scan) {
  return detect_legs(scan, robust_options().leg).legs;
}

// A person before a wall, one farther away, and a column.
LaserScan people() {
  IdealScene hall;
  hall.wall({-1.0, -3.0}, {5.0, -3.0});
  hall.wall({5.0, -3.0}, {5.0, 3.0});
  hall.wall({5.0, 3.0}, {-1.0, 3.0});
  hall.cylinder({3.0, -1.6}, 0.3);
  hall.cylinder({2.0, 0.15}, 0.06, Primitive::kLeg);
  hall.cylinder({2.1, -0.12}, 0.06, Primitive::kLeg);
  hall.cylinder({3.0, 1.6}, 0.065, Primitive::kLeg);
  hall.cylinder({3.1, 1.25}, 0.065, Primitive::kLeg);
  return testing::with_noise(hall.scan(), 0.004, 3);
}

TEST(ForestLegDetectorTest, FindsTheLegsOfPeopleAndNothingElseInAHall) {
  const std::vector<Leg> legs = legs_in(people());
  ASSERT_EQ(legs.size(), 4u);
  for (const Vector2d& at_m :
       {Vector2d(2.0, 0.15), Vector2d(2.1, -0.12), Vector2d(3.0, 1.6), Vector2d(3.1, 1.25)}) {
    const bool found = std::any_of(legs.begin(), legs.end(),
                                   [&](const Leg& leg) { return (leg.middle_m - at_m).norm() < 0.10; });
    EXPECT_TRUE(found) << at_m.transpose();
  }
}

TEST(ForestLegDetectorTest, LegsComeInTheOrderOfTheirBeamsAndApart) {
  const std::vector<Leg> legs = legs_in(people());
  for (std::size_t i = 1; i < legs.size(); ++i) {
    EXPECT_GT(legs[i].beams.first, legs[i - 1].beams.last);
    EXPECT_GE((legs[i].middle_m - legs[i - 1].middle_m).norm(), 0.10);
  }
}

TEST(ForestLegDetectorTest, TheLeastScoreIsWhatTheOptionsSay) {
  LegOptions options = robust_options().leg;
  options.min_score = options.min_doubtful_score = 0.01;
  const Features all = detect_legs(people(), options);
  ASSERT_FALSE(all.legs.empty());
  EXPECT_TRUE(all.doubtful_legs.empty());
  for (const Leg& leg : all.legs) EXPECT_LE(leg.score, 1.0);
  for (const Leg& bar : all.legs) {
    options.min_score = bar.score;
    const Features parted = detect_legs(people(), options);
    EXPECT_EQ(parted.legs.size() + parted.doubtful_legs.size(), all.legs.size());
    for (const Leg& leg : parted.legs) EXPECT_GE(leg.score, bar.score);
    for (const Leg& leg : parted.doubtful_legs) EXPECT_LT(leg.score, bar.score);
  }
}

TEST(ForestLegDetectorTest, ATurnedScanHasTurnedLegs) {
  LaserScan scan = people();
  const std::vector<Leg> legs = legs_in(scan);
  scan.geometry.first_rad += 0.7;
  const std::vector<Leg> turned = legs_in(scan);
  ASSERT_EQ(turned.size(), legs.size());
  const Pose2 turn{Vector2d::Zero(), 0.7};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    EXPECT_NEAR((turned[i].middle_m - turn * legs[i].middle_m).norm(), 0.0, 1e-9);
    EXPECT_NEAR(turned[i].score, legs[i].score, 0.05);
  }
}

TEST(ForestLegDetectorTest, AMirroredScanHasMirroredLegs) {
  LaserScan scan = people();
  const std::vector<Leg> legs = legs_in(scan);
  std::reverse(scan.range_m.begin(), scan.range_m.end());
  const std::vector<Leg> mirrored = legs_in(scan);
  ASSERT_EQ(mirrored.size(), legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& twin = mirrored[legs.size() - 1 - i];
    EXPECT_NEAR(twin.middle_m.x(), legs[i].middle_m.x(), 1e-9);
    EXPECT_NEAR(twin.middle_m.y(), -legs[i].middle_m.y(), 1e-9);
  }
}

TEST(ForestLegDetectorTest, ALaserThatTurnsClockwiseSeesTheSameLegs) {
  LaserScan scan = people();
  const std::vector<Leg> legs = legs_in(scan);
  std::reverse(scan.range_m.begin(), scan.range_m.end());
  scan.geometry.first_rad = -scan.geometry.first_rad;
  scan.geometry.step_rad = -scan.geometry.step_rad;
  const std::vector<Leg> clockwise = legs_in(scan);
  ASSERT_EQ(clockwise.size(), legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    EXPECT_NEAR((clockwise[legs.size() - 1 - i].middle_m - legs[i].middle_m).norm(), 0.0, 1e-9);
  }
}

TEST(ForestLegDetectorTest, AnyNumberOfBeamsAndAnyRangeIsFine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int num_beams : {0, 1, 2, 3, 10000}) {
    for (const double range_m : {0.0, 1e-9, 0.05, 2.0, 1e6, -3.0, nan, kNoEcho, kTooClose}) {
      for (const Leg& leg : legs_in(scan_of(std::vector<double>(num_beams, range_m)))) {
        EXPECT_TRUE(leg.middle_m.allFinite());
        EXPECT_GE(leg.score, 0.0);
        EXPECT_LE(leg.score, 1.0);
      }
    }
  }
  LaserScan flat = scan_of(std::vector<double>(361, 2.0));
  for (const double step_rad : {0.0, nan, 1e-300, 7.0}) {
    flat.geometry.step_rad = step_rad;
    EXPECT_NO_FATAL_FAILURE(legs_in(flat));
  }
}

TEST(ForestLegDetectorTest, TheScorerIsChosenByTheOptions) {
  const LaserScan scan = people();
  DetectorOptions options = robust_options();
  const auto by_forest = FeatureDetector(options).detect(scan).legs.size();
  options.leg.scorer = LegScorer::kRules;
  options.leg.min_score = 0.0;
  FeatureDetector rules(options);
  std::vector<Vector2d> middles;
  for (const Leg& leg : rules.detect(scan).legs) middles.push_back(leg.middle_m);
  FeatureDetector paper(paper_options());
  const std::vector<Leg>& expected = paper.detect(scan).legs;
  ASSERT_EQ(middles.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(middles[i], expected[i].middle_m);
  options.leg.enabled = false;
  rules.set_options(options);
  EXPECT_TRUE(rules.detect(scan).legs.empty());
  EXPECT_EQ(by_forest, 4u);
}

// The forest asks which circles there are, whether or not the user does.
TEST(ForestLegDetectorTest, LegsAreTheSameWhateverElseIsAskedFor) {
  const LaserScan scan = people();
  DetectorOptions options = robust_options();
  const std::vector<Leg> expected = FeatureDetector(options).detect(scan).legs;
  ASSERT_FALSE(expected.empty());
  options.circle.method = CircleMethod::kOff;
  options.line.method = LineMethod::kOff;
  DetectorOptions of_paper = paper_options();
  of_paper.leg = robust_options().leg;
  for (const DetectorOptions& other : {options, of_paper}) {
    FeatureDetector detector(other);
    const Features& features = detector.detect(scan);
    ASSERT_EQ(features.legs.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(features.legs[i].score, expected[i].score);
    const bool is_paper = other.pipeline == Pipeline::kPaper;
    EXPECT_EQ(features.circles.empty() && features.lines.empty(), !is_paper);
  }
}

}  // namespace
}  // namespace scanbed
