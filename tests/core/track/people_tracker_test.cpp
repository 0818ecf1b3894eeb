// SPDX-License-Identifier: MIT
#include "core/track/people_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

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

// A shin of somebody who walks along x, as the foot stands for 60 % of a cycle and is then
// as far behind the hip as it was ahead; the shin is 0.3 of the way from foot to hip.
double shin_ahead_m(double cycles, double stride_m) {
  const double phase = cycles - std::floor(cycles);
  const double foot = phase < 0.6 ? 0.3 - phase : -0.3 + (phase - 0.6) * 1.5;
  return 0.7 * foot * stride_m;
}

// Both of them, at 1.37 m/s: a stride of 1.44 m in 1.05 s.
std::vector<Leg> legs_by_gait(const Eigen::Vector2d& p_m, double forward, double cycles) {
  const double left_m = forward * shin_ahead_m(cycles, 1.44);
  const double right_m = forward * shin_ahead_m(cycles + 0.5, 1.44);
  return {leg_at(p_m + Eigen::Vector2d(left_m, 0.065)), leg_at(p_m + Eigen::Vector2d(right_m, -0.065))};
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

// Half a metre apart their legs are as near to each other as to their own; with 5 scans a second.
TEST(PeopleTrackerTest, TwoWhoBrushPastEachOtherKeepTheirTracksInAnyStep) {
  for (int phase = 0; phase < 100; ++phase) {
    Stage stage(0.19);
    const auto show = [&] {
      const double along_m = -2.5 + 1.37 * stage.time_s();
      const double cycles = stage.time_s() / 1.05;
      std::vector<Leg> legs = legs_by_gait({along_m, 2.0}, 1.0, cycles + 0.1 * (phase % 10));
      for (const Leg& leg : legs_by_gait({-along_m, 2.5}, -1.0, cycles + 0.1 * (phase / 10)))
        legs.push_back(leg);
      stage.show(legs);
    };
    for (int i = 0; i < 6; ++i) show();
    ASSERT_EQ(stage.tracks().size(), 2u) << phase;
    const std::uint64_t birth = stage.tracks()[0].birth;
    const bool first_goes_right = stage.tracks()[0].point.v_m_per_s.x() > 0.0;
    for (int i = 0; i < 14; ++i) show();
    ASSERT_EQ(stage.tracks().size(), 2u) << phase;
    EXPECT_EQ(stage.tracks()[0].birth, birth) << phase;
    EXPECT_NEAR(stage.tracks()[0].point.p_m.y(), first_goes_right ? 2.0 : 2.5, 0.1) << phase;
    EXPECT_EQ(stage.tracks()[0].point.v_m_per_s.x() > 0.0, first_goes_right) << phase;
  }
}

// Two stand 0.9 m apart and are not seen in one scan. Then one leg shows between them, a little nearer to
// the first: only when the first turns out to stand where it stood is it plain that the second one has moved.
TEST(PeopleTrackerTest, WhoseALegIsMayShowAScanLater) {
  Stage stage(0.2);
  for (int i = 0; i < 10; ++i)
    stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1}), leg_at({2.0, 1.0}), leg_at({2.0, 0.8})});
  ASSERT_EQ(stage.tracks().size(), 2u);
  const std::uint64_t first = stage.tracks()[0].birth;
  const std::uint64_t second = stage.tracks()[1].birth;
  stage.show({});
  stage.show({leg_at({2.0, 0.43})});
  for (int i = 0; i < 2; ++i)
    stage.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1}), leg_at({2.0, 0.43}), leg_at({2.0, 0.65})});
  ASSERT_EQ(stage.tracks().size(), 2u);
  for (const LiveTrack& track : stage.tracks()) {
    ASSERT_TRUE(track.birth == first || track.birth == second);
    EXPECT_NEAR(track.point.p_m.y(), track.birth == first ? 0.0 : 0.54, 0.15);
  }
}

// The test gives ids as the tracker does: to what is shown, and from there to all hypotheses.
TEST(PeopleTrackerTest, ATrackHasItsIdInAllHypotheses) {
  PeopleTracker tracker;
  int last_id = 0;
  std::set<std::pair<std::uint64_t, int>> seen;
  for (int i = 0; i < 30; ++i) {
    const LaserScan scan = open_scan(0.2 * i);
    const std::vector<Leg> legs = {leg_at({2.0, 0.2 + 0.05 * (i % 3)}), leg_at({2.0, -0.1}),
                                   leg_at({2.0, 0.55 - 0.05 * (i % 2)}), leg_at({2.0, 0.7})};
    tracker.update({scan, {}, i == 0 ? 0.0 : 0.2}, legs, TrackOptions{});
    for (LiveTrack& track : tracker.tracks()) {
      if (track.id == 0) track.id = ++last_id;
      seen.insert({track.birth, track.id});
    }
    tracker.spread_ids();
  }
  std::set<std::uint64_t> births;
  for (const auto& [birth, id] : seen) births.insert(birth);
  EXPECT_EQ(births.size(), seen.size());
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

// The gate is 0.6 m at most, and a stride of 0.35 m on top; within it, who stood is known too well to be 0.8
// m off two scans later.
TEST(PeopleTrackerTest, ALegAStrideAheadIsAPersonsStill) {
  for (const auto& [ahead_m, is_own] : {std::pair{0.7, true}, {0.8, false}, {1.0, false}}) {
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
