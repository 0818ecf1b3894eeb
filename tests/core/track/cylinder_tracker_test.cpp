// SPDX-License-Identifier: MIT
#include "core/track/cylinder_tracker.hpp"

#include <gtest/gtest.h>

#include "tests/core/track/made_features.hpp"

namespace scanbed {
namespace {

using testing::circle_at;
using testing::open_scan;

void show(CylinderTracker& tracker, double time_s, const std::vector<Circle>& circles) {
  const LaserScan scan = open_scan(time_s);
  const std::vector<char> no_leg(circles.size(), 0);
  tracker.update({scan, {}, time_s == 0.0 ? 0.0 : 0.1}, circles, no_leg, {});
}

TEST(CylinderTrackerTest, FollowsAMovingCylinderPastAStandingOne) {
  CylinderTracker tracker;
  for (int i = 0; i <= 40; ++i) {
    show(tracker, 0.1 * i, {circle_at({3.0, 0.0}, 0.25), circle_at({3.0 - 2.0 + 0.1 * i, 0.6}, 0.25)});
  }
  ASSERT_EQ(tracker.tracks().size(), 2u);
  EXPECT_FALSE(tracker.tracks()[0].is_mobile);
  EXPECT_TRUE(tracker.tracks()[0].is_settled());
  EXPECT_TRUE(tracker.tracks()[1].is_mobile);
  EXPECT_FALSE(tracker.tracks()[1].is_settled());
  EXPECT_EQ(tracker.tracks()[1].num_hits, 41);
  EXPECT_NEAR(tracker.tracks()[1].point.v_m_per_s.x(), 1.0, 0.02);
}

TEST(CylinderTrackerTest, RadiusTellsApartWhatStandsClose) {
  CylinderTracker tracker;
  for (int i = 0; i < 5; ++i)
    show(tracker, 0.1 * i, {circle_at({3.0, 0.0}, 0.25), circle_at({3.2, 0.1}, 0.10)});
  show(tracker, 0.5, {circle_at({3.15, 0.05}, 0.25)});
  ASSERT_EQ(tracker.tracks().size(), 2u);
  EXPECT_EQ(tracker.tracks()[0].feature, 0);
  EXPECT_EQ(tracker.tracks()[1].feature, kNoFeature);
}

TEST(CylinderTrackerTest, LegsAndCirclesOfOtherSizesAreNotFollowed) {
  CylinderTracker tracker;
  const LaserScan scan = open_scan(0.0);
  tracker.update({scan, {}, 0.0},
                 {circle_at({2.0, 0.0}, 0.11), circle_at({3.0, 0.0}, 0.05), circle_at({4.0, 0.0}, 3.0)},
                 {1, 0, 0}, {});
  EXPECT_TRUE(tracker.tracks().empty());
}

// 1 m/s along y behind a column that stands at 2 m; it turns back towards x where nobody sees it, and comes
// out a metre from where it would be by going straight on.
TEST(CylinderTrackerTest, WhatMovesMayTurnWhileItIsHidden) {
  CylinderTracker tracker;
  const Circle column = circle_at({2.0, 0.0}, 0.4);
  for (int i = 0; i <= 20; ++i) show(tracker, 0.1 * i, {column, circle_at({4.0, -3.0 + 0.1 * i}, 0.25)});
  for (int i = 21; i <= 30; ++i) {
    LaserScan scan = open_scan(0.1 * i);
    for (double& range_m : scan.range_m) range_m = 1.6;  // the column is all that is seen
    tracker.update({scan, {}, 0.1}, {column}, {0}, {});
  }
  show(tracker, 3.1, {column, circle_at({3.2, 0.7}, 0.25)});
  ASSERT_EQ(tracker.tracks().size(), 2u);
  EXPECT_EQ(tracker.tracks()[1].num_hits, 22);
}

// Its centre seems to drift while it goes out of sight; it has not moved by as much as would make it mobile.
TEST(CylinderTrackerTest, WhatStandsIsExpectedWhereItWas) {
  CylinderTracker tracker;
  for (int i = 0; i <= 10; ++i) show(tracker, 0.1 * i, {circle_at({3.0, 0.0}, 0.25)});
  for (int i = 11; i <= 13; ++i) show(tracker, 0.1 * i, {circle_at({3.0, 0.05 * (i - 10)}, 0.25)});
  const Eigen::Vector2d last_m = tracker.tracks()[0].point.p_m;
  for (int i = 14; i <= 30; ++i) {
    LaserScan scan = open_scan(0.1 * i);
    for (double& range_m : scan.range_m) range_m = 1.0;
    tracker.update({scan, {}, 0.1}, {}, {}, {});
  }
  ASSERT_EQ(tracker.tracks().size(), 1u);
  EXPECT_LT((tracker.tracks()[0].point.p_m - last_m).norm(), 0.06);
}

TEST(CylinderTrackerTest, OnceMobileItStaysSo) {
  CylinderTracker tracker;
  for (int i = 0; i <= 20; ++i) show(tracker, 0.1 * i, {circle_at({1.0 + 0.05 * i, 0.0}, 0.2)});
  for (int i = 21; i <= 100; ++i) show(tracker, 0.1 * i, {circle_at({2.0, 0.0}, 0.2)});
  ASSERT_EQ(tracker.tracks().size(), 1u);
  EXPECT_TRUE(tracker.tracks()[0].is_mobile);
  EXPECT_FALSE(tracker.tracks()[0].is_settled());
}

}  // namespace
}  // namespace scanbed
