// SPDX-License-Identifier: MIT
#include "core/track/people_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/core/track/made_features.hpp"

namespace scanbed {
namespace {

using testing::leg_at;
using testing::open_scan;

/// Feeds scans at a fixed rate to a tracker.
class Stage {
 public:
  explicit Stage(double period_s = 0.1) : period_s_(period_s) {}

  void show(const std::vector<Leg>& legs) {
    const LaserScan scan = open_scan(time_s_);
    tracker_.update({scan, {}, num_scans_ == 0 ? 0.0 : period_s_}, legs, options_);
    time_s_ += period_s_;
    ++num_scans_;
  }

  double time_s() const { return time_s_; }
  const std::vector<LiveTrack>& tracks() { return tracker_.tracks(); }
  int count(TrackKind kind) {
    int number = 0;
    for (const LiveTrack& track : tracks()) number += track.kind == kind ? 1 : 0;
    return number;
  }

 private:
  double period_s_;
  double time_s_ = 0.0;
  int num_scans_ = 0;
  TrackOptions options_;
  PeopleTracker tracker_;
};

// Both legs of somebody at p who walks along x: each swings by a quarter of a metre about the middle.
std::vector<Leg> legs_of_walker(const Eigen::Vector2d& p_m, double time_s) {
  const double swing_m = 0.25 * std::sin(6.0 * time_s);
  return {leg_at(p_m + Eigen::Vector2d(swing_m, 0.07)), leg_at(p_m + Eigen::Vector2d(-swing_m, -0.07))};
}

TEST(PeopleTrackerTest, TwoLegsBecomeOnePerson) {
  Stage stage;
  for (int i = 0; i < 3; ++i) stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.2})});
  ASSERT_EQ(stage.tracks().size(), 1u);
  EXPECT_EQ(stage.tracks()[0].kind, TrackKind::kPerson);
  EXPECT_NEAR((stage.tracks()[0].point.p_m - Eigen::Vector2d(2.0, -0.05)).norm(), 0.0, 1e-6);
}

TEST(PeopleTrackerTest, LegsFarApartStayTwo) {
  Stage stage;
  for (int i = 0; i < 5; ++i) stage.show({leg_at({2.0, 0.5}), leg_at({2.0, -0.5})});
  EXPECT_EQ(stage.count(TrackKind::kLeg), 2);
  EXPECT_EQ(stage.count(TrackKind::kPerson), 0);
}

TEST(PeopleTrackerTest, ASingleLegThatWalksIsAPerson) {
  Stage stage;
  for (int i = 0; i < 20; ++i) stage.show({leg_at({1.0 + 0.1 * i, 0.0})});
  ASSERT_EQ(stage.tracks().size(), 1u);
  EXPECT_EQ(stage.tracks()[0].kind, TrackKind::kPerson);
  EXPECT_NEAR(stage.tracks()[0].point.v_m_per_s.x(), 1.0, 0.1);
}

TEST(PeopleTrackerTest, AWalkerStaysOneAtAnyRate) {
  for (const double period_s : {0.0266, 0.1, 0.19}) {
    Stage stage(period_s);
    for (int i = 0; i < static_cast<int>(8.0 / period_s); ++i) {
      stage.show(legs_of_walker({-4.0 + 1.2 * stage.time_s(), 2.0}, stage.time_s()));
      EXPECT_EQ(stage.tracks().size(), 1u) << period_s << " " << i;
    }
    const LiveTrack& walker = stage.tracks()[0];
    EXPECT_EQ(walker.kind, TrackKind::kPerson);
    EXPECT_NEAR(walker.point.v_m_per_s.x(), 1.2, 0.15) << period_s;
    EXPECT_EQ(walker.num_hits, static_cast<int>(8.0 / period_s));
  }
}

TEST(PeopleTrackerTest, TwoWhoMeetHeadOnKeepTheirTracks) {
  Stage stage(0.1);
  const auto show = [&] {
    const double along_m = -3.0 + 1.2 * stage.time_s();
    std::vector<Leg> legs = legs_of_walker({along_m, 2.4}, stage.time_s());
    for (const Leg& leg : legs_of_walker({-along_m, 3.1}, stage.time_s() + 0.3)) legs.push_back(leg);
    stage.show(legs);
  };
  for (int i = 0; i < 8; ++i) show();
  ASSERT_EQ(stage.tracks().size(), 2u);
  const bool first_goes_right = stage.tracks()[0].point.v_m_per_s.x() > 0.0;
  for (int i = 0; i < 42; ++i) show();
  ASSERT_EQ(stage.tracks().size(), 2u);
  for (const LiveTrack& track : stage.tracks()) EXPECT_EQ(track.num_hits, 50);
  EXPECT_EQ(stage.tracks()[0].point.v_m_per_s.x() > 0.0, first_goes_right);
  EXPECT_NEAR(stage.tracks()[0].point.p_m.y(), first_goes_right ? 2.4 : 3.1, 0.1);
}

// Two stand a metre apart; one of them is out of sight for 0.4 s, of the other one leg is. A leg that shows
// 0.47 m from the one in sight is rather of the other, 0.53 m off: that one may have moved.
TEST(PeopleTrackerTest, ALegIsRatherOfWhosePlaceIsLessKnown) {
  Stage stage;
  for (int i = 0; i < 20; ++i)
    stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1}), leg_at({2.0, 1.1}), leg_at({2.0, 0.9})});
  for (int i = 0; i < 3; ++i) stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1})});
  stage.show({leg_at({2.0, -0.1}), leg_at({2.0, 0.47})});
  ASSERT_EQ(stage.tracks().size(), 2u);
  EXPECT_EQ(stage.tracks()[0].feature, 0);
  EXPECT_EQ(stage.tracks()[0].second_feature, kNoFeature);
  EXPECT_EQ(stage.tracks()[1].feature, 1);
}

// Each of two legs is none with 0.3, both with 0.09.
TEST(PeopleTrackerTest, TwoLegsAreSurerThanOne) {
  Stage stage;
  for (int i = 0; i < 60; ++i) stage.show({leg_at({2.0, 0.1}, 0.7), leg_at({2.0, -0.1}, 0.7)});
  ASSERT_EQ(stage.tracks().size(), 1u);
  EXPECT_NEAR(stage.tracks()[0].score(), 0.91, 1e-4);  // but for 0.8^60 of what it began with
}

// The gate is 0.6 m at most, and a stride of 0.35 m on top.
TEST(PeopleTrackerTest, ALegAStrideAheadIsAPersonsStill) {
  for (const auto& [ahead_m, is_own] : {std::pair{0.8, true}, {1.0, false}}) {
    Stage stage(0.19);
    for (int i = 0; i < 6; ++i) stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1})});
    stage.show({});
    stage.show({leg_at({2.0, ahead_m})});
    ASSERT_FALSE(stage.tracks().empty());
    EXPECT_EQ(stage.tracks()[0].kind, TrackKind::kPerson);
    EXPECT_EQ(stage.tracks()[0].feature != kNoFeature, is_own) << ahead_m;
  }
}

TEST(PeopleTrackerTest, APersonLivesOnOneLeg) {
  Stage stage;
  for (int i = 0; i < 30; ++i) {
    std::vector<Leg> legs = legs_of_walker({1.0 + 0.1 * i, 1.0}, stage.time_s());
    if (i % 4 == 2) legs.pop_back();
    stage.show(legs);
  }
  ASSERT_EQ(stage.tracks().size(), 1u);
  EXPECT_EQ(stage.tracks()[0].num_hits, 30);
}

TEST(PeopleTrackerTest, NobodyIsLeftWhenLegsAreGone) {
  Stage stage;
  for (int i = 0; i < 10; ++i) stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.2})});
  for (int i = 0; i < 10; ++i) stage.show({});
  EXPECT_TRUE(stage.tracks().empty());
}

}  // namespace
}  // namespace scanbed
