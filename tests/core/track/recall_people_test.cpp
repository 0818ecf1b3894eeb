// SPDX-License-Identifier: MIT
#include "core/track/recall_people.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace scanbed {
namespace {

using Eigen::Vector2d;

LiveTrack known(int id, const Vector2d& p_m) {
  LiveTrack track;
  track.id = id;
  track.birth = static_cast<std::uint64_t>(id);
  track.kind = TrackKind::kPerson;
  track.is_mobile = true;
  track.num_hits = 20;
  track.unseen_s = 1.0;
  track.age_s = 10.0;
  track.point = {.p_m = p_m, .var_p_m2 = 0.25};
  return track;
}

LiveTrack seen_at(TrackKind kind, const Vector2d& p_m, int feature) {
  LiveTrack track;
  track.birth = 100 + static_cast<std::uint64_t>(feature);
  track.kind = kind;
  track.num_hits = 1;
  track.log_odds = 1.0;
  track.point.p_m = p_m;
  track.feature = feature;
  return track;
}

TEST(RecallPeopleTest, WhoIsMostLikelyThereComesBack) {
  LostPeople lost;
  lost.remember(known(1, {2.0, 0.0}));
  std::vector<LiveTrack> tracks = {known(2, {2.0, 1.0}), seen_at(TrackKind::kPerson, {2.0, 0.8}, 0)};
  recall_people(tracks, lost, TrackOptions{});
  EXPECT_EQ(tracks[1].id, 2);
  EXPECT_EQ(tracks[1].birth, 2u);
  EXPECT_TRUE(tracks[0].is_dead);
  EXPECT_EQ(lost.people().size(), 1u);
  tracks = {seen_at(TrackKind::kPerson, {2.0, 0.2}, 0)};
  recall_people(tracks, lost, TrackOptions{});
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_TRUE(lost.people().empty());
}

TEST(RecallPeopleTest, EachComesBackOnce) {
  LostPeople lost;
  lost.remember(known(1, {2.0, 0.0}));
  std::vector<LiveTrack> tracks = {seen_at(TrackKind::kPerson, {2.0, 0.2}, 0),
                                   seen_at(TrackKind::kPerson, {2.0, -0.3}, 1)};
  recall_people(tracks, lost, TrackOptions{});
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[1].id, 0);
}

// 0.75 m about a person of whom one leg is seen, 0.5 m about one with two: these legs are theirs.
TEST(RecallPeopleTest, ALegBesideSomebodyIsNobodyElses) {
  for (const auto& [second_feature, beside_m, is_own] :
       {std::tuple{kNoFeature, 0.7, true}, {kNoFeature, 0.8, false}, {2, 0.45, true}, {2, 0.55, false}}) {
    LostPeople lost;
    lost.remember(known(1, {2.0, 0.0}));
    LiveTrack companion = seen_at(TrackKind::kPerson, {2.0, beside_m}, 1);
    companion.id = 5;
    companion.second_feature = second_feature;
    std::vector<LiveTrack> tracks = {companion, seen_at(TrackKind::kLeg, {2.0, 0.0}, 0)};
    recall_people(tracks, lost, TrackOptions{});
    EXPECT_EQ(tracks[1].id == 1, !is_own) << beside_m;
  }
}

TEST(RecallPeopleTest, NeitherWhoHasANameNorAnUnlikelyLegIsANewcomer) {
  LostPeople lost;
  lost.remember(known(1, {2.0, 0.0}));
  LiveTrack named = seen_at(TrackKind::kPerson, {2.0, 0.0}, 0);
  named.id = 4;
  LiveTrack unlikely = seen_at(TrackKind::kLeg, {2.0, -0.8}, 1);
  unlikely.log_odds = -0.1;
  std::vector<LiveTrack> tracks = {named, unlikely};
  recall_people(tracks, lost, TrackOptions{});
  EXPECT_EQ(tracks[0].id, 4);
  EXPECT_EQ(tracks[1].id, 0);
  EXPECT_EQ(lost.people().size(), 1u);
}

}  // namespace
}  // namespace scanbed
