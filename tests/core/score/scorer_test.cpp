// SPDX-License-Identifier: MIT
#include "core/score/scorer.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

TEST(ScorerTest, ScoresTracksWhereThereAre) {
  IdealScene scene;
  scene.cylinder({1.5, 0.8}, 0.25);
  Scorer scorer;
  EXPECT_FALSE(scorer.scores().person || scorer.scores().cylinder);
  const std::vector<Track> tracks = {{.id = 1, .kind = TrackKind::kCylinder, .position_m = {1.5, 0.7}},
                                     {.id = 2, .kind = TrackKind::kPerson, .position_m = {1.5, 0.7}}};
  LaserScan scan = scene.scan();
  scorer.add_tracks(tracks, scan, scene.truth());
  scan.time_s = 0.5;
  scorer.add_tracks(tracks, scan, scene.truth());
  ASSERT_TRUE(scorer.scores().person && scorer.scores().cylinder);
  EXPECT_DOUBLE_EQ(scorer.scores().cylinder->mota().value(), 1.0);
  EXPECT_DOUBLE_EQ(scorer.scores().cylinder->object_time_s, 0.5);
  EXPECT_EQ(scorer.scores().person->num_false, 2);
}

TEST(ScorerTest, PoolsTheCountsOfAllScansAndKinds) {
  IdealScene scene;
  scene.wall({3.0, -4.0}, {3.0, 4.0});
  scene.cylinder({1.5, 0.8}, 0.25);
  scene.cylinder({1.5, -0.8}, 0.07, Primitive::kLeg);
  Features features;
  features.circles.push_back({.center_m = {1.5, 0.8}, .radius_m = 0.25});
  features.legs.push_back({.middle_m = {1.45, -0.75}});
  Scorer scorer;
  scorer.add(features, scene.scan(), scene.truth());
  scorer.add({}, scene.scan(), scene.truth());
  EXPECT_EQ(scorer.scores().num_scans, 2);
  EXPECT_EQ(scorer.scores().circle.tally.num_truths, 2);
  EXPECT_EQ(scorer.scores().circle.tally.num_found, 1);
  EXPECT_EQ(scorer.scores().leg.tally.num_found, 1);
  EXPECT_EQ(scorer.scores().line.tally.num_found, 0);
  EXPECT_EQ(scorer.scores().line.tally.num_truths, 6);  // column and leg cut the wall into three pieces
}

TEST(ScorerTest, AScanWithoutObjectsScoresNothing) {
  const IdealScene nothing;
  Scorer scorer;
  scorer.add({}, nothing.scan(), nothing.truth());
  EXPECT_EQ(scorer.scores().line.tally.recall(), 1.0);
}

TEST(ScorerTest, RefusesGatesThatDoNotValidate) {
  EXPECT_THROW(Scorer({.leg_center_m = -1.0}), InputError);
}

}  // namespace
}  // namespace scanbed
