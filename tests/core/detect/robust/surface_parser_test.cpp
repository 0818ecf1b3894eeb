// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_parser.hpp"

#include <gtest/gtest.h>

#include "core/detect/feature_detector.hpp"
#include "core/score/scorer.hpp"
#include "tests/support/ideal_scene.hpp"
#include "tests/support/least_time.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

Features features_of(const LaserScan& scan) {
  return FeatureDetector(robust_options()).detect(scan);
}

Scores scores_of(const IdealScene& scene, double sigma_m, FeatureDetector detector) {
  Scorer scorer;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const LaserScan scan = with_noise(scene.scan(), sigma_m, seed);
    scorer.add(detector.detect(scan), scan, scene.truth());
  }
  return scorer.scores();
}

IdealScene hall() {
  IdealScene scene;
  scene.wall({-1.0, -3.5}, {6.5, -3.5});
  scene.wall({6.5, -3.5}, {6.5, 3.5});
  scene.wall({6.5, 3.5}, {-1.0, 3.5});
  scene.cylinder({3.0, 1.5}, 0.25);
  scene.cylinder({5.0, -1.5}, 0.25);
  scene.cylinder({2.0, -1.0}, 0.1);
  return scene;
}

TEST(SurfaceParserTest, FindsWhatIsInAHallAndNothingElse) {
  const Scores scores = scores_of(hall(), 0.005, FeatureDetector(robust_options()));
  EXPECT_GE(scores.circle.tally.recall(), 0.98);
  EXPECT_GE(scores.circle.tally.precision(), 0.98);
  EXPECT_LE(scores.circle.tally.rms_error_m(), 0.01);
  EXPECT_GE(scores.line.tally.recall(), 0.98);
  EXPECT_GE(scores.line.tally.precision(), 0.98);
}

TEST(SurfaceParserTest, IsBetterThanThePaperWhereNoiseIsHigh) {
  const Scores robust = scores_of(hall(), 0.012, FeatureDetector(robust_options()));
  const Scores paper = scores_of(hall(), 0.012, FeatureDetector(paper_options()));
  EXPECT_GT(robust.circle.tally.recall(), paper.circle.tally.recall() + 0.1);
  EXPECT_GE(robust.line.tally.recall(), paper.line.tally.recall());
}

TEST(SurfaceParserTest, ASquarePostIsNoCircle) {
  for (const double turn_deg : {0.0, 15.0, 30.0, 45.0}) {
    IdealScene scene;
    const double c = 0.2 * std::cos(radians(turn_deg));
    const double s = 0.2 * std::sin(radians(turn_deg));
    const Eigen::Vector2d corners_m[] = {
        {2.5 + c - s, c + s}, {2.5 - c - s, c - s}, {2.5 - c + s, -c - s}, {2.5 + c + s, -c + s}};
    for (int i = 0; i < 4; ++i) scene.wall(corners_m[i], corners_m[(i + 1) % 4]);
    EXPECT_TRUE(features_of(with_noise(scene.scan(), 0.005, 5)).circles.empty()) << turn_deg;
  }
}

TEST(SurfaceParserTest, ALongCorridorIsTwoWalls) {
  IdealScene scene;
  scene.wall({-1.0, 1.0}, {7.0, 1.0});
  scene.wall({-1.0, -1.0}, {7.0, -1.0});
  EXPECT_EQ(features_of(with_noise(scene.scan(), 0.005, 2)).lines.size(), 2u);
}

TEST(SurfaceParserTest, ScansThatHoldNothingGiveNothing) {
  LaserScan scan;
  EXPECT_TRUE(features_of(scan).lines.empty());
  for (const double range_m : {kInvalid, kNoEcho, kTooClose, 0.0}) {
    scan.range_m.assign(361, range_m);
    const Features features = features_of(scan);
    EXPECT_TRUE(features.lines.empty() && features.circles.empty()) << range_m;
  }
}

TEST(SurfaceParserTest, HugeScansAndHugeRangesAreFine) {
  LaserScan scan;
  scan.geometry.step_rad = 2 * kPi / 10000;
  scan.range_m.assign(10000, 2.0);
  EXPECT_NO_THROW(features_of(scan));
  scan.range_m.assign(361, 1e300);
  EXPECT_NO_THROW(features_of(scan));
}

// A spiral of small steps to and fro, ever nearer: each surface hides what lies behind from all that follow.
LaserScan stairs(int num_beams) {
  LaserScan scan;
  scan.geometry.num_beams = num_beams;
  scan.geometry.step_rad = 2 * kPi / num_beams;
  for (int i = 0; i < num_beams; ++i) {
    scan.range_m.push_back(0.6 + 0.5 * (num_beams - i) / num_beams + 0.3 * ((i / 4) % 2));
  }
  return scan;
}

double least_seconds_a_beam(int num_beams) {
  const LaserScan scan = stairs(num_beams);
  DetectorOptions options = robust_options();
  options.leg.enabled = false;
  FeatureDetector detector(options);
  return tests::least_seconds(0.0, [&] { detector.detect(scan); }) / num_beams;
}

TEST(SurfaceParserTest, ManySurfacesThatHideEachOtherTakeNoLongerEach) {
  // Were each compared with all behind it, 16 times as many would take 16 times as long each.
  EXPECT_LT(least_seconds_a_beam(16'000), 4.0 * least_seconds_a_beam(1000));
}

TEST(SurfaceParserTest, AColumnThatAPostCutsInTwoIsOneColumn) {
  int num_once = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    IdealScene scene;
    scene.wall({6.0, -4.0}, {6.0, 4.0});
    scene.cylinder({3.0, 0.0}, 0.35);
    scene.wall({1.5, -0.06}, {1.5, 0.06});
    const Features features = features_of(with_noise(scene.scan(), 0.005, seed));
    int num_here = 0;
    for (const Circle& circle : features.circles) {
      if ((circle.center_m - Eigen::Vector2d(3.0, 0.0)).norm() < 0.1) ++num_here;
    }
    if (num_here == 1 && features.circles.size() == 1u) ++num_once;
  }
  EXPECT_GE(num_once, 48);
}

TEST(SurfaceParserTest, ACylinderOfTooFewEchoesIsKnownButNotReported) {
  IdealScene scene;
  scene.cylinder({2.3, 0.0}, 0.05);
  const LaserScan scan = scene.scan();
  DetectorOptions options = robust_options();
  const Features few = FeatureDetector(options).detect(scan);
  EXPECT_TRUE(few.circles.empty());
  ASSERT_EQ(few.doubtful_circles.size(), 1u);
  const Circle& circle = few.doubtful_circles[0];
  EXPECT_EQ(circle.beams.last - circle.beams.first + 1, 5);
  EXPECT_NEAR((circle.center_m - Eigen::Vector2d(2.3, 0.0)).norm(), 0.0, 0.01);
  options.circle.min_points = 5;
  const Features enough = FeatureDetector(options).detect(scan);
  EXPECT_EQ(enough.circles.size(), 1u);
  EXPECT_TRUE(enough.doubtful_circles.empty());
}

TEST(SurfaceParserTest, AWallBehindAPostIsNoColumn) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    IdealScene scene;
    scene.wall({3.0, -1.0}, {3.0, 1.0});
    scene.wall({1.5, -0.06}, {1.5, 0.06});
    EXPECT_TRUE(features_of(with_noise(scene.scan(), 0.005, seed)).circles.empty()) << seed;
  }
}

TEST(SurfaceParserTest, ALargeColumnHasNoLines) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    IdealScene scene;
    scene.cylinder({2.0, 0.0}, 0.8);
    const Features features = features_of(with_noise(scene.scan(), 0.005, seed));
    EXPECT_EQ(features.circles.size(), 1u);
    EXPECT_TRUE(features.lines.empty());
  }
}

// It falls into more straight pieces than an arc is made of.
TEST(SurfaceParserTest, NorDoesOneThatAnAccurateSensorSees) {
  for (const double range_m : {3.0, 4.0, 6.0}) {
    IdealScene scene({.num_beams = 1081, .first_rad = radians(-135.0), .step_rad = radians(0.25)});
    scene.cylinder({range_m, 0.0}, 1.0);
    for (unsigned seed = 0; seed < 40; ++seed) {
      const Features features = features_of(with_noise(scene.scan(), 0.002, seed));
      EXPECT_EQ(features.circles.size(), 1u) << range_m << ' ' << seed;
      EXPECT_TRUE(features.lines.empty()) << range_m << ' ' << seed;
    }
  }
}

// A wall that begins where a round thing ends is one.
TEST(SurfaceParserTest, AWallBesideAnArcStays) {
  int num_found = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    IdealScene scene;
    scene.cylinder({2.0, 0.0}, 0.4);
    scene.wall({1.654, 0.2}, {1.654, 1.5});  // from its front on
    const Features features = features_of(with_noise(scene.scan(), 0.005, seed));
    EXPECT_EQ(features.circles.size(), 1u) << seed;
    num_found += features.lines.size() == 1 ? 1 : 0;
  }
  EXPECT_GE(num_found, 39);
}

}  // namespace
}  // namespace scanbed
