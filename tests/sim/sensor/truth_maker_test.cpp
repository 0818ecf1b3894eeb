// SPDX-License-Identifier: MIT
#include "sim/sensor/truth_maker.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

// Seven beams, 1 degree apart, looking along x; two rotations.
ScanGeometry seven_beams() {
  ScanGeometry geometry;
  geometry.num_beams = 7;
  geometry.first_rad = radians(-3.0);
  geometry.step_rad = radians(1.0);
  return geometry;
}

const std::vector<SliceObject> kObjects = {{"wall", "wall", Primitive::kLine, 0.0},
                                           {"leg", "leg", Primitive::kLeg, 0.06}};

/// Wall 5 m ahead, leg at a place.
PlanarSlice slice_with_leg(const Vector2d& p_WL) {
  PlanarSlice slice;
  slice.segments = {{{5, -2}, {5, 2}, 0}};
  slice.discs = {{p_WL, 0.06, 1}};
  return slice;
}

IdealReturns nothing() {
  IdealReturns returns;
  returns.reset(7);
  return returns;
}

/// Truth of a scan whose two rotations see the leg at two places.
Truth truth_of(const Vector2d& even_m, const Vector2d& odd_m, double max_range_m = 10.0) {
  TruthMaker maker(kObjects, 7);
  maker.begin({});
  IdealReturns returns = nothing();
  for (int rotation : {0, 1}) {
    RayCaster caster(seven_beams(), {rotation, 2});
    const PlanarSlice slice = slice_with_leg(rotation == 0 ? even_m : odd_m);
    caster.cast(slice, {});
    returns.take_axes(caster);
    maker.add_piece({rotation, 2}, slice, {});
  }
  maker.finish(returns, max_range_m);
  return maker.truth();
}

TEST(TruthMakerTest, BeamsOfBothRotationsAreMerged) {
  // 0.06 m at 2 m is 1.7 degrees: beams 2, 3 and 4 meet the leg.
  const Truth truth = truth_of({2, 0}, {2, 0});
  std::vector<int> objects;
  for (const BeamTruth& beam : truth.beams) objects.push_back(beam.object);
  EXPECT_EQ(objects, (std::vector<int>{0, 0, 1, 1, 1, 0, 0}));
  EXPECT_EQ(truth.objects[0].num_clean_beams, 4);
  EXPECT_EQ(truth.objects[1].num_clean_beams, 3);
  EXPECT_NEAR(truth.beams[3].range_m, 1.94, 1e-12);
  EXPECT_NEAR(truth.beams[3].incidence_rad, 0.0, 1e-6);
}

TEST(TruthMakerTest, AnObjectIsWhereItsMiddleBeamSawIt) {
  const Truth odd_in_the_middle = truth_of({2, 0}, {2, 0.001});
  EXPECT_EQ(odd_in_the_middle.objects[1].center_m, Vector2d(2, 0.001));
  // The odd rotation sees the leg off to the side: beams 2 and 4 are left, and the later one is the middle.
  const Truth even_only = truth_of({2, 0}, {2, 1});
  EXPECT_EQ(even_only.objects[1].num_clean_beams, 2);
  EXPECT_EQ(even_only.objects[1].center_m, Vector2d(2, 0));
}

TEST(TruthMakerTest, AnObjectThatNobodySawIsWhereItWasAtTheScansTime) {
  const Truth truth = truth_of({2, 1}, {2, 1.1});
  EXPECT_EQ(truth.objects[1].num_clean_beams, 0);
  EXPECT_EQ(truth.objects[1].center_m, Vector2d(2, 1));
}

TEST(TruthMakerTest, ReturnsBeyondTheRangeAreNone) {
  const Truth truth = truth_of({2, 0}, {2, 0}, 4.0);
  EXPECT_EQ(truth.beams[0].object, kNoObject);
  EXPECT_EQ(truth.beams[0].range_m, kNoEcho);
  EXPECT_EQ(truth.beams[0].incidence_rad, 0.0);
  EXPECT_EQ(truth.objects[0].num_clean_beams, 0);
  EXPECT_EQ(truth.objects[1].num_clean_beams, 3);
}

TEST(TruthMakerTest, EachRotationHasItsOwnSensorPose) {
  TruthMaker maker(kObjects, 7);
  const Pose2 poses[] = {{{0, 0}, 0.0}, {{0.5, 0}, 0.0}};
  maker.begin(poses[0]);
  const PlanarSlice slice = slice_with_leg({9, 9});
  IdealReturns returns = nothing();
  for (int rotation : {0, 1}) {
    RayCaster caster(seven_beams(), {rotation, 2});
    caster.cast(slice, poses[rotation]);
    returns.take_axes(caster);
    maker.add_piece({rotation, 2}, slice, poses[rotation]);
  }
  maker.finish(returns, 10.0);
  EXPECT_EQ(maker.truth().X_WS.p_m, Vector2d(0, 0));
  EXPECT_NEAR(maker.truth().beams[3].range_m, 4.5, 1e-12);        // odd
  EXPECT_EQ(maker.truth().objects[0].from_m, Vector2d(4.5, -2));  // of seven beams the middle one is odd
  EXPECT_EQ(maker.truth().objects[0].to_m, Vector2d(4.5, 2));
}

TEST(TruthMakerTest, AScanLeavesNothingBehindForTheNext) {
  TruthMaker maker(kObjects, 7);
  RayCaster caster(seven_beams());
  for (const Vector2d& p_WL : {Vector2d(2, 0), Vector2d(2, 1)}) {
    const PlanarSlice slice = slice_with_leg(p_WL);
    maker.begin({});
    caster.cast(slice, {});
    IdealReturns returns = nothing();
    returns.take_axes(caster);
    maker.add_piece({}, slice, {});
    maker.finish(returns, 10.0);
  }
  EXPECT_EQ(maker.truth().objects[1].num_clean_beams, 0);
  EXPECT_EQ(maker.truth().objects[0].num_clean_beams, 7);
}

// Beams 2, 3 and 4 meet the leg; 2 has an edge in its spot.
TEST(TruthMakerTest, MixedBeamsAreMarkedAndNotCountedAsClean) {
  TruthMaker maker(kObjects, 7);
  maker.begin({});
  IdealReturns returns = nothing();
  const PlanarSlice early = slice_with_leg({2, 0});
  const PlanarSlice late = slice_with_leg({2, 0.001});
  for (int first : {0, 4}) {
    const BeamSubset beams{first, 1, first == 0 ? 4 : 3};
    RayCaster caster(seven_beams(), beams);
    caster.cast(first == 0 ? early : late, {});
    returns.take_axes(caster);
    maker.add_piece(beams, first == 0 ? early : late, {});
  }
  returns.split_spots = {{2, 0, 0}};
  maker.finish(returns, 10.0);
  const Truth& truth = maker.truth();
  EXPECT_TRUE(truth.beams[2].mixed);
  EXPECT_FALSE(truth.beams[3].mixed);
  EXPECT_EQ(truth.beams[2].object, 1);  // its axis
  EXPECT_EQ(truth.objects[1].num_clean_beams, 2);
  EXPECT_EQ(truth.objects[1].center_m, Vector2d(2, 0.001));  // of beams 3 and 4 the later
}

// A polynomial; its source states an error of at most 2e-8.
TEST(TruthMakerTest, IncidenceIsTheArcCosine) {
  TruthMaker maker({{"wall", "wall", Primitive::kLine, 0.0}}, 1);
  for (double cosine = 0.0; cosine <= 1.0; cosine += 0.001) {
    maker.begin({});
    maker.add_piece({}, PlanarSlice{}, {});
    IdealReturns returns;
    returns.reset(1);
    returns.object[0] = 0;
    returns.range_m[0] = 1.0;
    returns.cos_incidence[0] = cosine;
    maker.finish(returns, 10.0);
    // The handbook says 2e-8, to one digit: its leading term alone misses pi / 2 by 2.18e-8.
    ASSERT_NEAR(maker.truth().beams[0].incidence_rad, std::acos(cosine), 2.2e-8);
  }
}

}  // namespace
}  // namespace scanbed::sim
