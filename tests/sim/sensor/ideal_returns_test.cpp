// SPDX-License-Identifier: MIT
#include "sim/sensor/ideal_returns.hpp"

#include <gtest/gtest.h>

#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {
namespace {

TEST(IdealReturnsTest, AfterAResetNothingIsMet) {
  IdealReturns returns;
  returns.split_spots.push_back({0, 0, 1});
  returns.spot_returns.emplace_back();
  returns.reset(3);
  EXPECT_EQ(returns.range_m, (std::vector<double>(3, kNoEcho)));
  EXPECT_EQ(returns.object, (std::vector<int>(3, kNoObject)));
  EXPECT_EQ(returns.cos_incidence, (std::vector<double>(3, 1.0)));
  EXPECT_TRUE(returns.split_spots.empty());
  EXPECT_TRUE(returns.spot_returns.empty());
}

// A wall 2 m ahead, met 45 degrees off its normal by the second of two beams of a subset.
TEST(IdealReturnsTest, TakesTheBeamsOfASubsetToTheirPlacesInTheScan) {
  ScanGeometry geometry;
  geometry.num_beams = 5;
  geometry.first_rad = -kPi / 2;
  geometry.step_rad = kPi / 4;
  RayCaster caster(geometry, {2, 1, 2});
  ASSERT_EQ(caster.num_beams(), 2);
  PlanarSlice slice;
  slice.segments = {{{2, -5}, {2, 5}, 7}};
  caster.cast(slice, {});
  IdealReturns returns;
  returns.reset(5);
  returns.take_axes(caster);
  EXPECT_EQ(returns.object, (std::vector<int>{kNoObject, kNoObject, 7, 7, kNoObject}));
  EXPECT_NEAR(returns.range_m[2], 2.0, 1e-12);
  EXPECT_NEAR(returns.range_m[3], 2.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(returns.cos_incidence[2], 1.0, 1e-12);
  EXPECT_NEAR(returns.cos_incidence[3], std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace scanbed::sim
