// SPDX-License-Identifier: MIT
#include "core/detect/chord.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/arc_points.hpp"

namespace scanbed {
namespace {

using testing::all_of;
using testing::append;
using testing::arc;

TEST(ChordTest, DepthIsPositiveOnTheSensorsSideWhicheverWayTheBeamsTurn) {
  for (const bool clockwise : {false, true}) {
    Points points;
    append(points, {2.0, clockwise ? 1.0 : -1.0});
    append(points, {1.5, 0.0});
    append(points, {2.0, clockwise ? -1.0 : 1.0});
    const Chord chord = chord_of(points, all_of(points));
    EXPECT_DOUBLE_EQ(chord.length_m, 2.0);
    EXPECT_DOUBLE_EQ(chord.depth_m({1.5, 0.0}), 0.5);
    EXPECT_DOUBLE_EQ(chord.depth_m({3.0, 0.0}), -1.0);
  }
}

TEST(ChordTest, ASegmentThatStartsWhereItEndsHasNoDepth) {
  Points points;
  append(points, {1.0, 1.0});
  append(points, {2.0, 1.0});
  append(points, {1.0, 1.0});
  EXPECT_EQ(chord_of(points, all_of(points)).depth_m({5.0, 5.0}), 0.0);
  EXPECT_FALSE(bulges_like_an_arc(points, all_of(points), 0.1, 0.7));
}

TEST(ChordTest, TheMiddleOfAnArcLiesASagittaBelowTheChord) {
  // Sagitta / chord = tan(a / 4) / 2 for a central angle a: 0.5 for half a circle, 0.1 at a = 45.24 degrees.
  const auto bulges = [](double central_deg) {
    const Points points = arc({3.0, 0.5}, 0.3, radians(central_deg), 21);
    return bulges_like_an_arc(points, all_of(points), 0.1, 0.7);
  };
  EXPECT_TRUE(bulges(180.0));
  EXPECT_TRUE(bulges(46.0));
  EXPECT_FALSE(bulges(44.5));
}

TEST(ChordTest, HollowsAndStraightRunsDoNotBulge) {
  Points hollow;
  append(hollow, {2.0, -0.2});
  append(hollow, {2.1, 0.0});
  append(hollow, {2.0, 0.2});
  EXPECT_FALSE(bulges_like_an_arc(hollow, all_of(hollow), 0.1, 0.7));
  Points straight;
  for (const double y_m : {-0.2, 0.0, 0.2}) append(straight, {2.0, y_m});
  EXPECT_FALSE(bulges_like_an_arc(straight, all_of(straight), 0.1, 0.7));
}

TEST(ChordTest, ADeepSpikeDoesNotBulgeLikeAnArc) {
  Points spike;
  append(spike, {2.0, -0.1});
  append(spike, {1.85, 0.0});  // 0.75 of the chord
  append(spike, {2.0, 0.1});
  EXPECT_FALSE(bulges_like_an_arc(spike, all_of(spike), 0.1, 0.7));
  EXPECT_TRUE(bulges_like_an_arc(spike, all_of(spike), 0.1, 0.8));
}

TEST(ChordTest, OfTwoPointsInTheMiddleTheDeeperCountsFromEitherSide) {
  const std::vector<Eigen::Vector2d> lopsided = {{2.0, -0.2}, {1.97, -0.07}, {1.9, 0.07}, {2.0, 0.2}};
  Points points, mirrored;
  for (const Eigen::Vector2d& p : lopsided) append(points, p);
  for (auto p = lopsided.rbegin(); p != lopsided.rend(); ++p) append(mirrored, {p->x(), -p->y()});
  EXPECT_TRUE(bulges_like_an_arc(points, all_of(points), 0.2, 0.3));  // 0.25 of the chord
  EXPECT_TRUE(bulges_like_an_arc(mirrored, all_of(mirrored), 0.2, 0.3));
}

}  // namespace
}  // namespace scanbed
