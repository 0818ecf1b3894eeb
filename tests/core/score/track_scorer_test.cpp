// SPDX-License-Identifier: MIT
#include "core/score/track_scorer.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

Track person(int id, double x_m, double y_m = 0.0) {
  return {.id = id, .kind = TrackKind::kPerson, .position_m = {x_m, y_m}};
}

FollowedTruth truth(const char* id, double x_m, Visibility visibility = Visibility::kResolvable) {
  return {id, {x_m, 0.0}, visibility};
}

TEST(TrackScorerTest, CountsMatchesMissesAndFalseTracks) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0), truth("b", 3.0)}, {person(1, 1.2), person(2, 6.0)}, 0.0);
  const TrackTally tally = scorer.tally();
  EXPECT_EQ(tally.num_truths, 2);
  EXPECT_EQ(tally.num_matches, 1);
  EXPECT_EQ(tally.num_false, 1);
  EXPECT_NEAR(tally.sum_error_m, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(tally.mota().value(), 0.0);  // one miss and one false of two
}

TEST(TrackScorerTest, AMatchIsKeptThoughAnotherTrackIsNearer) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0)}, {person(1, 1.1)}, 0.0);
  scorer.add({truth("a", 1.0)}, {person(1, 1.4), person(2, 1.0)}, 0.1);
  EXPECT_EQ(scorer.tally().num_switches, 0);
  EXPECT_EQ(scorer.tally().num_false, 1);
}

TEST(TrackScorerTest, ASwitchIsCountedOnceAlsoAfterAGap) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0)}, {person(1, 1.0)}, 0.0);
  scorer.add({truth("a", 1.0)}, {}, 30.0);
  scorer.add({truth("a", 1.0)}, {person(2, 1.0)}, 15.0);
  scorer.add({truth("a", 1.0)}, {person(2, 1.0)}, 15.0);
  EXPECT_EQ(scorer.tally().num_switches, 1);
  EXPECT_DOUBLE_EQ(scorer.tally().switches_per_minute().value(), 1.0);
  EXPECT_DOUBLE_EQ(scorer.tally().mota().value(), 1.0 - 2.0 / 4.0);
}

TEST(TrackScorerTest, TwoWhoTakeEachOthersTrackAreTwoSwitches) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0), truth("b", 3.0)}, {person(1, 1.0), person(2, 3.0)}, 0.0);
  scorer.add({truth("a", 1.0), truth("b", 3.0)}, {person(2, 1.0), person(1, 3.0)}, 0.1);
  EXPECT_EQ(scorer.tally().num_switches, 2);
  EXPECT_EQ(scorer.tally().num_matches, 4);
  EXPECT_EQ(scorer.tally().num_identity_true, 2);
  EXPECT_DOUBLE_EQ(scorer.tally().idf1().value(), 0.5);
}

TEST(TrackScorerTest, WhatNeedNotBeFoundExcusesATrackAndKeepsItsName) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0)}, {person(1, 1.0)}, 0.0);
  scorer.add({truth("a", 1.0, Visibility::kHidden)}, {person(1, 1.1)}, 1.0);
  scorer.add({truth("a", 1.0, Visibility::kMarginal)}, {}, 1.0);
  scorer.add({truth("a", 1.0)}, {person(1, 1.0)}, 1.0);
  const TrackTally tally = scorer.tally();
  EXPECT_EQ(tally.num_truths, 2);
  EXPECT_EQ(tally.num_neither, 1);
  EXPECT_EQ(tally.num_false, 0);
  EXPECT_EQ(tally.num_switches, 0);
  EXPECT_DOUBLE_EQ(tally.mota().value(), 1.0);
  EXPECT_DOUBLE_EQ(tally.idf1().value(), 1.0);
  EXPECT_DOUBLE_EQ(tally.object_time_s, 2.0);  // hidden, it is not in view
}

TEST(TrackScorerTest, WhatPassesBeforeAHiddenObjectDoesNotTakeItsName) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0)}, {person(1, 1.0)}, 0.0);
  scorer.add({truth("a", 1.0, Visibility::kHidden)}, {person(2, 0.7)}, 0.1);
  scorer.add({truth("a", 1.0)}, {person(1, 1.0)}, 0.1);
  EXPECT_EQ(scorer.tally().num_switches, 0);
  EXPECT_EQ(scorer.tally().num_neither, 1);
}

TEST(TrackScorerTest, IdentitiesAreThoseOfTheWholeRun) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  for (int i = 0; i < 10; ++i) scorer.add({truth("a", 1.0)}, {person(i < 7 ? 1 : 2, 1.0)}, 0.1);
  EXPECT_EQ(scorer.tally().num_identity_true, 7);
  EXPECT_DOUBLE_EQ(scorer.tally().idf1().value(), 14.0 / 20.0);
}

// The track on the hidden one is near the other one too; it counts for neither, and IDF1 never exceeds 1.
TEST(TrackScorerTest, AnExcusedTrackIsNobodysIdentity) {
  TrackScorer scorer(TrackKind::kPerson, 0.5);
  scorer.add({truth("a", 1.0, Visibility::kMarginal)}, {person(1, 1.0)}, 0.0);
  for (int i = 0; i < 4; ++i) {
    scorer.add({truth("a", 1.0, Visibility::kHidden), truth("b", 1.3)}, {person(1, 1.1)}, 0.1);
  }
  const TrackTally tally = scorer.tally();
  EXPECT_EQ(tally.num_truths, 4);
  EXPECT_EQ(tally.num_neither, 5);
  EXPECT_EQ(tally.num_identity_tracks, 0);
  EXPECT_EQ(tally.num_identity_true, 0);
  EXPECT_EQ(tally.idf1(), 0.0);
}

TEST(TrackScorerTest, OtherKindsAreNotLookedAt) {
  TrackScorer scorer(TrackKind::kCylinder, 0.5);
  scorer.add({truth("col", 1.0)}, {person(1, 1.0)}, 0.0);
  EXPECT_EQ(scorer.tally().num_matches, 0);
  EXPECT_EQ(scorer.tally().num_false, 0);
}

}  // namespace
}  // namespace scanbed
