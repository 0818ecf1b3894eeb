// SPDX-License-Identifier: MIT
#include "scenarios/load/time_window.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

TEST(TimeWindowTest, HoldsBothItsEnds) {
  const TimeWindow window{5.0, 12.0};
  EXPECT_TRUE(window.contains(5.0));
  EXPECT_TRUE(window.contains(12.0));
  EXPECT_FALSE(window.contains(4.999));
  EXPECT_FALSE(window.contains(12.001));
  EXPECT_EQ(to_string(window), "5 to 12 s");
}

TEST(TimeWindowTest, IsTheWholeRunUnlessTold) {
  EXPECT_TRUE(TimeWindow{}.is_whole());
  EXPECT_TRUE(TimeWindow{}.contains(1e9));
  EXPECT_FALSE((TimeWindow{0.0, 12.0}).is_whole());
}

}  // namespace
}  // namespace scanbed::scenarios
