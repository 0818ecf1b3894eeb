// SPDX-License-Identifier: MIT
#include "core/score/track_tally.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

TEST(TrackTallyTest, MeasuresAreThoseOfThePapers) {
  const TrackTally tally{.num_truths = 200,
                         .num_matches = 180,
                         .num_false = 6,
                         .num_switches = 4,
                         .sum_error_m = 18.0,
                         .object_time_s = 120.0,
                         .num_identity_true = 150,
                         .num_identity_tracks = 190};
  EXPECT_DOUBLE_EQ(tally.mota().value(), 1.0 - (20 + 6 + 4) / 200.0);
  EXPECT_DOUBLE_EQ(tally.motp_m().value(), 0.1);
  EXPECT_DOUBLE_EQ(tally.switches_per_minute().value(), 2.0);
  EXPECT_DOUBLE_EQ(tally.idf1().value(), 300.0 / 390.0);
}

TEST(TrackTallyTest, OfNothingNothingIsMeasured) {
  const TrackTally none;
  EXPECT_FALSE(none.mota() || none.idf1() || none.motp_m() || none.switches_per_minute());
  const TrackTally only_false{.num_false = 3, .num_identity_tracks = 3};
  EXPECT_FALSE(only_false.mota() || only_false.motp_m() || only_false.switches_per_minute());
  EXPECT_EQ(only_false.idf1(), 0.0);
}

// 1 - 187 / 200 is not 0.065 to the last digit.
TEST(TrackTallyTest, AMotaOfABarReachesIt) {
  EXPECT_EQ((TrackTally{.num_truths = 200, .num_matches = 13}).mota(), 0.065);
}

TEST(TrackTallyTest, RunsAddUp) {
  TrackTally sum{.num_truths = 10, .num_matches = 9, .object_time_s = 1.0, .num_identity_true = 8};
  sum += {.num_truths = 30,
          .num_matches = 20,
          .num_false = 2,
          .num_neither = 1,
          .num_switches = 3,
          .sum_error_m = 0.5,
          .object_time_s = 2.0,
          .num_identity_true = 1,
          .num_identity_tracks = 7};
  EXPECT_EQ(sum.num_truths, 40);
  EXPECT_EQ(sum.num_matches, 29);
  EXPECT_EQ(sum.num_false, 2);
  EXPECT_EQ(sum.num_neither, 1);
  EXPECT_EQ(sum.num_switches, 3);
  EXPECT_EQ(sum.sum_error_m, 0.5);
  EXPECT_EQ(sum.object_time_s, 3.0);
  EXPECT_EQ(sum.num_identity_true, 9);
  EXPECT_EQ(sum.num_identity_tracks, 7);
}

}  // namespace
}  // namespace scanbed
