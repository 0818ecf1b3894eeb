// SPDX-License-Identifier: MIT
#include "core/track/place_history.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

PlaceHistory walked(double speed_m_per_s, double period_s, double for_s) {
  PlaceHistory history;
  for (int i = 0; i * period_s <= for_s; ++i) {
    history.add(i * period_s, {speed_m_per_s * i * period_s, 0.0}, 2.0);
  }
  return history;
}

TEST(PlaceHistoryTest, WalkingMovesByTwoThirdsOfTheWindow) {
  // Of n even entries the thirds' means lie n - n/3 entries apart: 2/3 of the window and up to an entry more.
  for (const double period_s : {0.0266, 0.1, 0.19, 0.2}) {
    const PlaceHistory history = walked(1.2, period_s, 20.0);
    EXPECT_GT(history.net_displacement_m(), 1.2 * 2.0 * 0.6) << period_s;
    EXPECT_LT(history.net_displacement_m(), 1.2 * 2.0 * 0.8) << period_s;
    EXPECT_LE(history.span_s(), 2.0 + 1e-9);
    EXPECT_GT(history.span_s(), 1.7);
  }
}

TEST(PlaceHistoryTest, GoingToAndFroMovesNothing) {
  PlaceHistory history;
  for (int i = 0; i < 200; ++i) history.add(0.1 * i, {i % 2 == 0 ? 0.3 : -0.3, 0.0}, 2.0);
  EXPECT_LT(history.net_displacement_m(), 0.11);  // thirds of odd size are off by one entry of six
}

TEST(PlaceHistoryTest, ForgetsWhatIsOlderThanTheWindow) {
  PlaceHistory history = walked(1.0, 0.1, 5.0);
  for (int i = 1; i <= 30; ++i) history.add(5.0 + 0.1 * i, {5.0, 0.0}, 2.0);
  EXPECT_DOUBLE_EQ(history.net_displacement_m(), 0.0);
}

TEST(PlaceHistoryTest, FewEntriesSayNothing) {
  PlaceHistory history;
  EXPECT_EQ(history.net_displacement_m(), 0.0);
  EXPECT_EQ(history.span_s(), 0.0);
  history.add(0.0, {0.0, 0.0}, 2.0);
  history.add(1.0, {5.0, 0.0}, 2.0);
  EXPECT_EQ(history.net_displacement_m(), 0.0);
}

TEST(PlaceHistoryTest, AClockThatJumpsBackBeginsAnew) {
  PlaceHistory history = walked(1.0, 0.1, 5.0);
  history.add(1.0, {0.0, 0.0}, 2.0);
  EXPECT_EQ(history.span_s(), 0.0);
}

TEST(PlaceHistoryTest, AShiftIsNoDisplacement) {
  PlaceHistory history;
  for (int i = 0; i < 5; ++i) history.add(0.1 * i, {0.0, 0.0}, 2.0);
  history.shift({1.0, -2.0});
  for (int i = 5; i < 10; ++i) history.add(0.1 * i, {1.0, -2.0}, 2.0);
  EXPECT_NEAR(history.net_displacement_m(), 0.0, 1e-12);
}

}  // namespace
}  // namespace scanbed
