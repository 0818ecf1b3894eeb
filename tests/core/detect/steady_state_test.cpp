// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/detect/feature_detector.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

class SteadyStateTest : public ::testing::TestWithParam<Pipeline> {};

TEST_P(SteadyStateTest, DetectionAllocatesNothingOnceItHasSeenTheScan) {
  testing::IdealScene hall;
  hall.wall({-1.0, -3.0}, {5.0, -3.0});
  hall.wall({5.0, -3.0}, {5.0, 3.0});
  hall.cylinder({3.0, 1.0}, 0.25);
  hall.cylinder({2.0, -0.5}, 0.07, Primitive::kLeg);
  hall.cylinder({2.1, -0.2}, 0.07, Primitive::kLeg);
  const LaserScan scan = testing::with_noise(hall.scan(), 0.002, 3);
  FeatureDetector detector(GetParam() == Pipeline::kPaper ? paper_options() : robust_options());
  const Features& features = detector.detect(scan);
  ASSERT_FALSE(features.lines.empty() || features.circles.empty() || features.legs.empty());
  const std::int64_t before = testing::num_allocations();
  for (int repeat = 0; repeat < 100; ++repeat) detector.detect(scan);
  EXPECT_EQ(testing::num_allocations() - before, 0);
}

INSTANTIATE_TEST_SUITE_P(Presets, SteadyStateTest, ::testing::Values(Pipeline::kPaper, Pipeline::kRobust));

TEST(AllocationCounterTest, TheCounterCounts) {
  const std::int64_t before = testing::num_allocations();
  const std::vector<int> one_allocation(1000);
  EXPECT_EQ(testing::num_allocations() - before, 1);
  EXPECT_EQ(one_allocation[999], 0);
}

}  // namespace
}  // namespace scanbed
