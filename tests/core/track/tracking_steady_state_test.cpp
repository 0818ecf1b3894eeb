// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/track/tracker.hpp"
#include "tests/core/track/made_features.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

TEST(TrackingSteadyStateTest, TrackingAllocatesNothingOnceItHasSeenAsMuch) {
  testing::IdealScene hall;
  hall.wall({-1.0, -3.0}, {5.0, -3.0});
  hall.wall({5.0, -3.0}, {5.2, 3.0});
  LaserScan scan = testing::with_noise(hall.scan(), 0.002, 3);
  Features features;
  for (int i = 0; i < 6; ++i) {
    features.circles.push_back(testing::circle_at({1.0 + i, 2.0}, 0.25));
    features.legs.push_back(testing::leg_at({1.0 + i, 0.1}));
    features.legs.push_back(testing::leg_at({1.0 + i, -0.1}));
  }
  const Features nothing;
  Tracker tracker;
  const auto run = [&](int num_scans) {
    for (int i = 0; i < num_scans; ++i) {
      scan.time_s += 0.1;
      tracker.update(scan, i % 40 > 25 ? nothing : features);  // tracks are born and die
    }
  };
  run(100);
  ASSERT_FALSE(tracker.tracks().empty());
  const std::int64_t before = testing::num_allocations();
  run(200);
  EXPECT_EQ(testing::num_allocations() - before, 0);
}

}  // namespace
}  // namespace scanbed
