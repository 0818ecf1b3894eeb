// SPDX-License-Identifier: MIT
#include "sim/planar/sector_culler.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/scan/truth.hpp"
#include "tests/sim/planar/lms_spot.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using testing::kLmsSpot;

IdealReturns cast(const PlanarSlice& slice, const Pose2& X_LS, BeamSubset subset, bool culled) {
  const ScanGeometry geometry;
  SectorCuller culler(geometry, subset, kLmsSpot);
  RayCaster axes(geometry, subset);
  SpotCaster spots(geometry, subset, kLmsSpot);
  const PlanarSlice& seen = culled ? culler.cull(slice, X_LS) : slice;
  axes.cast(seen, X_LS);
  IdealReturns returns;
  returns.reset(geometry.num_beams);
  returns.take_axes(axes);
  spots.cast(seen, X_LS, axes, returns);
  return returns;
}

Vector2d arbitrary_place() {
  const auto coordinate = rc::gen::inRange(-800, 800);
  return {*coordinate / 100.0, *coordinate / 100.0};
}

PlanarSlice arbitrary_slice() {
  PlanarSlice slice;
  int object = 0;
  for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
    slice.segments.push_back({arbitrary_place(), arbitrary_place(), object++});
  }
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
    slice.discs.push_back({arbitrary_place(), *rc::gen::inRange(1, 100) / 100.0, object++});
  }
  return slice;
}

void expect_same(const IdealReturns& a, const IdealReturns& b) {
  RC_ASSERT(a.range_m == b.range_m);
  RC_ASSERT(a.cos_incidence == b.cos_incidence);
  RC_ASSERT(a.object == b.object);
  RC_ASSERT(a.split_spots.size() == b.split_spots.size());
  for (std::size_t i = 0; i < a.split_spots.size(); ++i) {
    RC_ASSERT(a.split_spots[i].beam == b.split_spots[i].beam);
    RC_ASSERT(a.split_spots[i].first == b.split_spots[i].first);
  }
  for (std::size_t i = 0; i < a.spot_returns.size(); ++i) {
    RC_ASSERT(a.spot_returns[i].range_m == b.spot_returns[i].range_m);
    RC_ASSERT(a.spot_returns[i].object == b.spot_returns[i].object);
  }
}

RC_GTEST_PROP(SectorCullerTest, TheBeamsMeetTheSame, ()) {
  const PlanarSlice slice = arbitrary_slice();
  const Pose2 X_LS{arbitrary_place(), *rc::gen::inRange(-314, 314) / 100.0};
  const int stride = *rc::gen::inRange(1, 3);
  const BeamSubset subset{*rc::gen::inRange(0, 300), stride, *rc::gen::inRange(1, 200)};
  expect_same(cast(slice, X_LS, subset, true), cast(slice, X_LS, subset, false));
}

// Beams of 0 to 30 degrees from the origin, along x.
TEST(SectorCullerTest, LeavesOutWhatLiesToOneSide) {
  SectorCuller culler({}, {180, 1, 61}, kLmsSpot);
  PlanarSlice slice;
  slice.segments = {{{1, -1}, {5, -1}, 0},     // to the right
                    {{1, 4}, {-1, 4}, 1},      // to the left
                    {{-2, -1}, {-2, 1}, 2},    // behind
                    {{3, -1}, {3, 5}, 3},      // across
                    {{4, -0.01}, {4, -3}, 4},  // in the first beam's spot
                    {{1, -2}, {-1, 2}, 5}};    // through the sensor
  slice.discs = {{{3, -0.5}, 0.3, 6}, {{3, -0.5}, 0.6, 7}, {{-1, -1}, 2.0, 8}};
  const PlanarSlice& rest = culler.cull(slice, {});
  std::vector<int> objects;
  for (const SliceSegment& segment : rest.segments) objects.push_back(segment.object);
  for (const SliceDisc& disc : rest.discs) objects.push_back(disc.object);
  EXPECT_EQ(objects, (std::vector<int>{3, 4, 5, 7, 8}));
}

TEST(SectorCullerTest, HalfATurnKeepsAll) {
  SectorCuller culler({}, {}, kLmsSpot);
  PlanarSlice slice;
  slice.segments = {{{-3, -1}, {-3, 1}, 0}};
  EXPECT_EQ(&culler.cull(slice, {}), &slice);
}

}  // namespace
}  // namespace scanbed::sim
