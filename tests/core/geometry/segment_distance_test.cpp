// SPDX-License-Identifier: MIT
#include "core/geometry/segment_distance.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

TEST(SegmentDistanceTest, IsToTheNearestOfItsPoints) {
  const Eigen::Vector2d from_m(1.0, 1.0);
  const Eigen::Vector2d to_m(4.0, 1.0);
  EXPECT_EQ(segment_distance_m({2.0, 3.0}, from_m, to_m), 2.0);   // beside it
  EXPECT_EQ(segment_distance_m({-2.0, 5.0}, from_m, to_m), 5.0);  // before its beginning: 3, 4, 5
  EXPECT_EQ(segment_distance_m({7.0, -3.0}, from_m, to_m), 5.0);  // behind its end
  EXPECT_EQ(segment_distance_m({3.0, 1.0}, from_m, to_m), 0.0);
}

TEST(SegmentDistanceTest, OfAPointIsToThatPoint) {
  EXPECT_EQ(segment_distance_m({4.0, 5.0}, {1.0, 1.0}, {1.0, 1.0}), 5.0);
}

}  // namespace
}  // namespace scanbed
