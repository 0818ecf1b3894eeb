// SPDX-License-Identifier: MIT
#include "core/detect/segmentation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scanbed {
namespace {

Points points_on_x(const std::vector<double>& x_m) {
  Points points;
  for (std::size_t i = 0; i < x_m.size(); ++i) {
    points.x_m.push_back(x_m[i]);
    points.y_m.push_back(0.0);
    points.beam.push_back(static_cast<int>(i));
  }
  return points;
}

std::vector<Segment> segments_of(const Points& points, const SegmentationOptions& options = {}) {
  std::vector<Segment> segments;
  segment_points(points, options, segments);
  return segments;
}

TEST(SegmentationTest, CutsWherePointsAreFartherApartThanTheThreshold) {
  const auto segments = segments_of(points_on_x({0.0, 0.079, 0.158, 0.239, 0.3}));
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].last, 2);
  EXPECT_EQ(segments[1].first, 3);
}

TEST(SegmentationTest, MeasuresBetweenPointsAndNotBetweenRanges) {
  Points points;  // two echoes at the same range, 90 degrees apart
  points.x_m = {1.0, 0.0};
  points.y_m = {0.0, 1.0};
  points.beam = {0, 1};
  EXPECT_TRUE(segments_of(points).empty());
}

TEST(SegmentationTest, RejectsIsolatedPoints) {
  const auto segments = segments_of(points_on_x({0.0, 1.0, 1.01, 2.0}));
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].first, 1);
  EXPECT_EQ(segments[0].num_points(), 2);
}

TEST(SegmentationTest, CutsAtABeamWithoutEcho) {
  Points points = points_on_x({0.0, 0.01, 0.02, 0.03});
  points.beam = {0, 1, 3, 4};
  EXPECT_EQ(segments_of(points).size(), 2u);
}

TEST(SegmentationTest, NoPointsMakeNoSegments) {
  EXPECT_TRUE(segments_of({}).empty());
  EXPECT_TRUE(segments_of(points_on_x({1.0})).empty());
}

RC_GTEST_PROP(SegmentationTest, EverySegmentIsARunOfNearPointsAndEveryCutIsAJump,
              (const std::vector<int>& steps_mm)) {
  std::vector<double> x_m = {0.0};
  for (const int step_mm : steps_mm) x_m.push_back(x_m.back() + std::abs(step_mm % 200) / 1000.0);
  const Points points = points_on_x(x_m);
  std::vector<int> segment_of(points.size(), -1);
  int number = 0;
  for (const Segment& segment : segments_of(points)) {
    RC_ASSERT(segment.num_points() >= 2);
    for (int k = segment.first; k <= segment.last; ++k) segment_of[k] = number;
    ++number;
  }
  for (int k = 1; k < points.size(); ++k) {
    const bool near = x_m[k] - x_m[k - 1] < SegmentationOptions{}.max_gap_m;
    const bool together = segment_of[k] >= 0 && segment_of[k] == segment_of[k - 1];
    RC_ASSERT(near == together);
  }
}

}  // namespace
}  // namespace scanbed
