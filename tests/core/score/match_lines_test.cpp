// SPDX-License-Identifier: MIT
#include "core/score/match_lines.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

Line line_from(Eigen::Vector2d left_m, Eigen::Vector2d right_m, BeamSpan beams = {0, 10}) {
  Line line;
  line.left_m = left_m;
  line.right_m = right_m;
  line.beams = beams;
  return line;
}

Tally tally_of(const IdealScene& scene, const std::vector<Line>& lines) {
  return match_lines(lines, scene.scan(), scene.truth(), {}).tally;
}

IdealScene wall_ahead() {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.0, 1.0});
  return scene;
}

TEST(MatchLinesTest, ALineOnTheWallFindsIt) {
  const Tally tally = tally_of(wall_ahead(), {line_from({2.02, -0.9}, {2.02, 0.9})});
  EXPECT_EQ(tally.num_truths, 1);
  EXPECT_EQ(tally.num_found, 1);
  EXPECT_EQ(tally.num_right, 1);
  EXPECT_NEAR(tally.rms_error_m(), 0.02, 1e-12);
}

TEST(MatchLinesTest, ALineOffInAngleOrPositionIsWrong) {
  const double lean_m = std::tan(radians(3.2));
  for (const Line& off :
       {line_from({2.06, -0.9}, {2.06, 0.9}), line_from({2.0 - lean_m, -1.0}, {2.0 + lean_m, 1.0})}) {
    const Tally tally = tally_of(wall_ahead(), {off});
    EXPECT_EQ(tally.num_found, 0);
    EXPECT_EQ(tally.num_detections, 1);
    EXPECT_EQ(tally.num_right, 0);
  }
}

TEST(MatchLinesTest, HalfOfTheVisibleSpanMustBeCovered) {
  EXPECT_EQ(tally_of(wall_ahead(), {line_from({2.0, -1.0}, {2.0, -0.1})}).num_found, 0);
  EXPECT_EQ(tally_of(wall_ahead(), {line_from({2.0, -1.0}, {2.0, 0.1})}).num_found, 1);
  EXPECT_EQ(tally_of(wall_ahead(), {line_from({2.0, -1.0}, {2.0, -0.1})}).num_right, 1);
}

TEST(MatchLinesTest, AWallMayBeFoundInSeveralLinesAndOverlapCountsOnce) {
  const Tally halves =
      tally_of(wall_ahead(), {line_from({2.0, -1.0}, {2.0, -0.4}), line_from({2.0, 0.2}, {2.0, 0.8})});
  EXPECT_EQ(halves.num_found, 1);
  EXPECT_EQ(halves.num_right, 2);
  const Tally twice =
      tally_of(wall_ahead(), {line_from({2.0, -1.0}, {2.0, -0.4}), line_from({2.0, -1.0}, {2.0, -0.4})});
  EXPECT_EQ(twice.num_found, 0);
}

TEST(MatchLinesTest, OneLineMayFindCollinearWalls) {
  IdealScene scene;
  scene.wall({2.0, -1.5}, {2.0, -0.3});
  scene.wall({2.0, 0.3}, {2.0, 1.5});
  const Tally tally = tally_of(scene, {line_from({2.0, -1.5}, {2.0, 1.5})});
  EXPECT_EQ(tally.num_truths, 2);
  EXPECT_EQ(tally.num_found, 2);
  EXPECT_EQ(tally.num_right, 1);
}

TEST(MatchLinesTest, ALineThatMostlyRunsThroughThinAirIsWrong) {
  EXPECT_EQ(tally_of(wall_ahead(), {line_from({2.0, -1.0}, {2.0, 4.0})}).num_right, 0);
}

TEST(MatchLinesTest, ALineOnAStubIsNeitherRightNorWrong) {
  IdealScene scene;
  scene.wall({1.0, -0.1}, {1.0, 0.1});
  const Tally fits = tally_of(scene, {line_from({1.0, -0.1}, {1.0, 0.1})});
  EXPECT_EQ(fits.num_detections, 0);
  EXPECT_EQ(fits.num_neither, 1);
  // Badly fitted, but on the stub's beams: -5.7 to 5.7 degrees are beams 169 to 191.
  const Tally leans = tally_of(scene, {line_from({0.95, -0.1}, {1.05, 0.1}, {169, 191})});
  EXPECT_EQ(leans.num_neither, 1);
}

TEST(MatchLinesTest, ALineOnNothingIsWrongAndAMissedWallIsMissed) {
  const Tally tally = tally_of(wall_ahead(), {line_from({5.0, 2.0}, {6.0, 2.0})});
  EXPECT_EQ(tally.num_detections, 1);
  EXPECT_EQ(tally.num_right, 0);
  EXPECT_EQ(tally.recall(), 0.0);
}

TEST(MatchLinesTest, ALineWithoutLengthIsNoMatch) {
  EXPECT_EQ(tally_of(wall_ahead(), {line_from({2.0, 0.0}, {2.0, 0.0})}).num_right, 0);
}

}  // namespace
}  // namespace scanbed
