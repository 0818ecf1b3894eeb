// SPDX-License-Identifier: MIT
#include "core/track/tracker.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"
#include "tests/core/track/made_features.hpp"

namespace scanbed {
namespace {

using testing::circle_at;
using testing::leg_at;
using testing::open_scan;

Features walker_and_column(double time_s) {
  Features features;
  features.circles = {circle_at({4.0, 1.5}, 0.25)};
  features.legs = {leg_at({1.0 + time_s, 0.1}), leg_at({1.0 + time_s, -0.1})};
  return features;
}

// p and its like seen by a sensor at X_WS.
Features seen_from(const Pose2& X_WS, Features features) {
  const Pose2 X_SW = X_WS.inverse();
  for (Circle& circle : features.circles) circle.center_m = X_SW * circle.center_m;
  for (Leg& leg : features.legs) leg.middle_m = X_SW * leg.middle_m;
  return features;
}

TEST(TrackerTest, ReportsFromTheSecondHitOn) {
  Tracker tracker;
  EXPECT_TRUE(tracker.update(open_scan(0.0), walker_and_column(0.0), Pose2{}).empty());
  const std::vector<Track>& tracks = tracker.update(open_scan(0.1), walker_and_column(0.1), Pose2{});
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[0].kind, TrackKind::kPerson);
  EXPECT_EQ(tracks[1].id, 2);
  EXPECT_EQ(tracks[1].kind, TrackKind::kCylinder);
  EXPECT_EQ(tracks[1].radius_m, 0.25);
}

TEST(TrackerTest, ReportsTwoLegsThatLeaveNoDoubtAtOnce) {
  for (const double score : {0.94, 0.96}) {
    Features features;
    features.legs = {leg_at({2.0, 0.1}, score), leg_at({2.0, -0.1}, score)};
    Tracker tracker;
    EXPECT_EQ(tracker.update(open_scan(0.0), features, Pose2{}).size(), score > 0.95 ? 1u : 0u);
    features.legs.pop_back();
    Tracker of_one_leg;
    EXPECT_TRUE(of_one_leg.update(open_scan(0.0), features, Pose2{}).empty());
  }
}

TEST(TrackerTest, KeepsIdsAndGivesVelocitiesOverGroundWhileTheSensorDrives) {
  Tracker tracker;
  for (int i = 0; i <= 30; ++i) {
    const double time_s = 0.1 * i;
    const Pose2 X_WS{{-0.3 * time_s, 0.1 * time_s}, 0.4 * time_s};
    const std::vector<Track>& tracks =
        tracker.update(open_scan(time_s), seen_from(X_WS, walker_and_column(time_s)), X_WS);
    if (i == 0) continue;
    ASSERT_EQ(tracks.size(), 2u);
    EXPECT_EQ(tracks[0].id, 1);
    EXPECT_EQ(tracks[1].id, 2);
    if (i < 20) continue;
    EXPECT_NEAR((X_WS.rotate(tracks[0].velocity_m_per_s) - Eigen::Vector2d(1.0, 0.0)).norm(), 0.0, 0.1);
    EXPECT_NEAR(tracks[1].velocity_m_per_s.norm(), 0.0, 0.05);
    EXPECT_NEAR((X_WS * tracks[0].position_m - Eigen::Vector2d(1.0 + time_s, 0.0)).norm(), 0.0, 0.05);
    EXPECT_TRUE(tracks[1].is_settled);
  }
}

Features two_legs_at(const Eigen::Vector2d& p_m) {
  Features features;
  features.legs = {leg_at(p_m + Eigen::Vector2d(0.0, 0.1)), leg_at(p_m - Eigen::Vector2d(0.0, 0.1))};
  return features;
}

// Somebody walks for 2 s at 1 m/s, is gone for 2 s, and somebody stands 1.5 m aside from where the way led.
TEST(TrackerTest, WhoComesBackIsTheSamePerson) {
  Tracker tracker;
  double time_s = 0.0;
  for (; time_s < 2.0; time_s += 0.1)
    tracker.update(open_scan(time_s), two_legs_at({1.0 + time_s, 0.0}), Pose2{});
  for (; time_s < 4.0; time_s += 0.1) tracker.update(open_scan(time_s), Features{}, Pose2{});
  EXPECT_TRUE(tracker.tracks().empty());
  const std::vector<Track>& tracks = tracker.update(open_scan(time_s), two_legs_at({4.0, 1.5}), Pose2{});
  ASSERT_EQ(tracks.size(), 1u);  // at once: it is nobody new
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[0].kind, TrackKind::kPerson);
}

TEST(TrackerTest, OneLegIsEnoughToKnowWhoWalkedThere) {
  Tracker tracker;
  double time_s = 0.0;
  for (; time_s < 2.0; time_s += 0.1)
    tracker.update(open_scan(time_s), two_legs_at({1.0 + time_s, 0.0}), Pose2{});
  for (; time_s < 4.0; time_s += 0.1) tracker.update(open_scan(time_s), Features{}, Pose2{});
  Features one_leg;
  one_leg.legs = {leg_at({4.0, 1.5})};
  const std::vector<Track>& tracks = tracker.update(open_scan(time_s), one_leg, Pose2{});
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].id, 1);
}

TEST(TrackerTest, WhoIsTooFarOffOrComesTooLateIsSomebodyElse) {
  // In 1 s nobody gets 6 m away; after 12 s nobody is remembered.
  for (const auto& [gone_s, back_m] : {std::pair{1.0, Eigen::Vector2d(3.0, -6.0)}, {12.0, {3.0, 0.5}}}) {
    Tracker tracker;
    double time_s = 0.0;
    for (; time_s < 2.0; time_s += 0.1)
      tracker.update(open_scan(time_s), two_legs_at({1.0 + time_s, 0.0}), Pose2{});
    for (; time_s < 2.0 + gone_s; time_s += 0.1) tracker.update(open_scan(time_s), Features{}, Pose2{});
    for (int i = 0; i < 3; ++i, time_s += 0.1)
      tracker.update(open_scan(time_s), two_legs_at(back_m), Pose2{});
    ASSERT_EQ(tracker.tracks().size(), 1u);
    EXPECT_EQ(tracker.tracks()[0].id, 2) << gone_s;
  }
}

// Furniture that looks like two legs is not known again elsewhere.
TEST(TrackerTest, WhatNeverWalkedHasNoWayBack) {
  Tracker tracker;
  double time_s = 0.0;
  for (; time_s < 2.0; time_s += 0.1) tracker.update(open_scan(time_s), two_legs_at({3.0, 0.0}), Pose2{});
  EXPECT_EQ(tracker.tracks().size(), 1u);
  for (; time_s < 3.0; time_s += 0.1) tracker.update(open_scan(time_s), Features{}, Pose2{});
  for (; time_s < 4.0; time_s += 0.1) tracker.update(open_scan(time_s), two_legs_at({3.0, 1.0}), Pose2{});
  ASSERT_EQ(tracker.tracks().size(), 1u);
  EXPECT_EQ(tracker.tracks()[0].id, 2);
}

TEST(TrackerTest, TurningTheWorldTurnsTheTracks) {
  const Pose2 X_VW{{2.0, -1.0}, 1.1};  // the same events, in another frame of the sensor
  Tracker plain;
  Tracker turned;
  for (int i = 0; i <= 20; ++i) {
    const double time_s = 0.1 * i;
    const std::vector<Track> a = plain.update(open_scan(time_s), walker_and_column(time_s), Pose2{});
    const std::vector<Track>& b =
        turned.update(open_scan(time_s), seen_from(X_VW.inverse(), walker_and_column(time_s)), Pose2{});
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].id, b[k].id);
      EXPECT_EQ(a[k].kind, b[k].kind);
      EXPECT_NEAR((X_VW * a[k].position_m - b[k].position_m).norm(), 0.0, 1e-9);
      EXPECT_NEAR((X_VW.rotate(a[k].velocity_m_per_s) - b[k].velocity_m_per_s).norm(), 0.0, 1e-9);
    }
  }
}

TEST(TrackerTest, NewOptionsLoseNoTrack) {
  Tracker tracker;
  for (int i = 0; i < 10; ++i) tracker.update(open_scan(0.1 * i), walker_and_column(0.1 * i), Pose2{});
  TrackOptions options;
  options.gate_m = 0.3;
  options.displacement_window_s = 1.0;
  tracker.set_options(options);
  const std::vector<Track>& tracks = tracker.update(open_scan(1.0), walker_and_column(1.0), Pose2{});
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[1].id, 2);
  options.gate_m = -1.0;
  EXPECT_THROW(tracker.set_options(options), InputError);
  EXPECT_EQ(tracker.options().gate_m, 0.3);
}

TEST(TrackerTest, DoubtfulPeopleAreFollowedButNotReported) {
  Tracker tracker;
  for (int i = 0; i < 10; ++i) {
    Features features;
    features.legs = {leg_at({2.0, 0.1}, 0.2), leg_at({2.0, -0.1}, 0.2)};
    EXPECT_TRUE(tracker.update(open_scan(0.1 * i), features, Pose2{}).empty());
  }
  Features features;
  features.legs = {leg_at({2.0, 0.1}, 0.99), leg_at({2.0, -0.1}, 0.99)};
  for (int i = 10; i < 20; ++i) tracker.update(open_scan(0.1 * i), features, Pose2{});
  EXPECT_EQ(tracker.tracks().size(), 1u);
}

// Somebody's legs that are hardly seen for a while.
TEST(TrackerTest, ALegInDoubtKeepsATrackAndIsNotNamed) {
  for (const bool is_told : {true, false}) {
    Tracker tracker;
    double time_s = 0.0;
    for (; time_s < 2.0; time_s += 0.1)
      tracker.update(open_scan(time_s), two_legs_at({1.0 + time_s, 0.0}), Pose2{});
    for (; time_s < 3.0; time_s += 0.1) {
      Features features;
      if (is_told) features.doubtful_legs = two_legs_at({1.0 + time_s, 0.0}).legs;
      tracker.update(open_scan(time_s), features, Pose2{});
    }
    ASSERT_EQ(tracker.tracks().size(), is_told ? 1u : 0u);
    if (!is_told) continue;
    EXPECT_EQ(tracker.tracks()[0].id, 1);
    EXPECT_EQ(tracker.tracks()[0].feature, kNoFeature);
    EXPECT_EQ(tracker.tracks()[0].second_feature, kNoFeature);
    EXPECT_NEAR(tracker.tracks()[0].position_m.x(), 0.9 + time_s, 0.05);
  }
}

TEST(TrackerTest, ALegThatIsACircleTooIsNoCylinder) {
  Tracker tracker;
  for (int i = 0; i < 5; ++i) {
    Features features;
    features.legs = {leg_at({2.0, 0.1})};
    features.legs[0].beams = {100, 106};
    features.circles = {circle_at({2.05, 0.1}, 0.10)};
    features.circles[0].beams = {99, 107};
    const std::vector<Track>& tracks = tracker.update(open_scan(0.1 * i), features, Pose2{});
    for (const Track& track : tracks) EXPECT_EQ(track.kind, TrackKind::kLeg);
  }
  EXPECT_EQ(tracker.tracks().size(), 1u);
}

TEST(TrackerTest, ThinCirclesStandInForLegsThatTheRulesMiss) {
  for (const double score : {0.5, 0.0}) {
    TrackOptions options;
    options.thin_circle_score = score;
    Tracker tracker(options);
    for (int i = 0; i < 30; ++i) {
      Features features;
      features.circles = {circle_at({1.0 + 0.1 * i, 0.1}, 0.06), circle_at({1.0 + 0.1 * i, -0.1}, 0.06)};
      features.circles[0].beams = {190, 195};
      features.circles[1].beams = {170, 175};
      tracker.update(open_scan(0.1 * i), features, Pose2{});
    }
    ASSERT_EQ(tracker.tracks().size(), score > 0.0 ? 1u : 0u);  // who walks so far is somebody
    if (score > 0.0) {
      EXPECT_EQ(tracker.tracks()[0].kind, TrackKind::kPerson);
      EXPECT_EQ(tracker.tracks()[0].feature, kNoFeature);  // no leg of the features shows it
    }
  }
}

TEST(TrackerTest, OddScansAndClocksAreFine) {
  Tracker tracker;
  LaserScan empty;
  empty.geometry.num_beams = 0;
  tracker.update(empty, Features{});
  tracker.update(open_scan(5.0), walker_and_column(0.0));
  tracker.update(open_scan(1.0), walker_and_column(0.1));
  tracker.update(open_scan(1e9), walker_and_column(0.2));
  LaserScan timeless = open_scan(std::nan(""));
  tracker.update(timeless, walker_and_column(0.3));
  tracker.update(open_scan(2.0), walker_and_column(0.4));
  for (const Track& track : tracker.tracks()) EXPECT_TRUE(track.position_m.allFinite());
}

}  // namespace
}  // namespace scanbed
