// SPDX-License-Identifier: MIT
#include "core/score/tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed {
namespace {

TEST(TallyTest, RatiosFollowTheirDefinitions) {
  const Tally tally{
      .num_truths = 8, .num_found = 6, .num_detections = 10, .num_right = 7, .sum_squared_error_m2 = 0.07};
  EXPECT_DOUBLE_EQ(tally.precision(), 0.7);
  EXPECT_DOUBLE_EQ(tally.recall(), 0.75);
  EXPECT_DOUBLE_EQ(tally.rms_error_m(), 0.1);
}

TEST(TallyTest, NothingToFindAndNothingFoundIsPerfect) {
  EXPECT_EQ(Tally{}.precision(), 1.0);
  EXPECT_EQ(Tally{}.recall(), 1.0);
  EXPECT_EQ(Tally{}.rms_error_m(), 0.0);
}

TEST(TallyTest, TruthsFallIntoBandsOfTwoMetresTheLastOfThemOpen) {
  KindScore score;
  score.count_truth(1.9, true);
  score.count_truth(2.0, false);
  score.count_truth(100.0, true);
  score.count_truth(HUGE_VAL, true);
  EXPECT_EQ(score.bands[0].num_found, 1);
  EXPECT_EQ(score.bands[1].num_truths, 1);
  EXPECT_EQ(score.bands[1].recall(), 0.0);
  EXPECT_EQ(score.bands[4].num_found, 2);
  EXPECT_EQ(score.tally.num_truths, 4);
  EXPECT_EQ(score.tally.num_found, 3);
}

TEST(TallyTest, FalseDetectionsAreCountedPerScan) {
  Scores scores;
  EXPECT_FALSE(scores.false_per_scan(scores.leg) || scores.false_per_scan(TrackTally{}));
  scores.num_scans = 4;
  scores.leg.tally = {.num_detections = 5, .num_right = 3};
  EXPECT_DOUBLE_EQ(scores.false_per_scan(scores.leg).value(), 0.5);
  EXPECT_DOUBLE_EQ(scores.false_per_scan(TrackTally{.num_false = 1}).value(), 0.25);
}

}  // namespace
}  // namespace scanbed
