// SPDX-License-Identifier: MIT
#include "sim/planar/slice_objects.hpp"

#include <gtest/gtest.h>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

World world_with_everything() {
  World world;
  world.solids.push_back({"hall", "wall", WallChain{{{-4, -1}, {4, -1}, {4, 6}}, false}, 0, 2.5, {}});
  world.solids.push_back({"seat", "bench", Box{{{0, 3}, 0}, {1, 1}}, 0.4, 0.45, {}});
  world.solids.push_back({"column", "column", Cylinder{{1, 3}, 0.25}, 0, 2.5, {}});
  world.solids.push_back({"wedge", "box", Polygon{{{5, 7}, {6, 7}, {5, 8}}}, 0, 1, {}});
  for (const char* id : {"anna", "ben"}) {
    Walker walker;
    walker.id = id;
    walker.path.points_m = {{0, 0}, {1, 0}};
    walker.tow = Tow{};
    walker.tow->id = walker.id + "s_cylinder";
    world.walkers.push_back(walker);
  }
  world.walkers[1].leg_radius_m = 0.07;
  world.walkers[0].tow->height_m = 0.2;  // below the laser
  return world;
}

WorldState everything_present() {
  WorldState state;
  state.walkers = {{.walker = 0, .present = true}, {.walker = 1, .present = true}};
  state.walkers[0].left_leg_m = {1, 1};
  state.walkers[0].right_leg_m = {1, 2};
  state.walkers[1].left_leg_m = {2, 1};
  state.walkers[1].right_leg_m = {2, 2};
  state.tows = {{0, true, {7, 7}}, {1, true, {8, 8}}};
  return state;
}

TEST(SliceObjectsTest, CountsWhatReachesTheLasersPlane) {
  const SliceObjects objects(world_with_everything());
  std::string ids;
  for (const SliceObject& object : objects.objects()) ids += object.id + " ";
  EXPECT_EQ(ids,
            "hall.0 hall.1 column wedge.0 wedge.1 wedge.2 anna.left_leg anna.right_leg ben.left_leg "
            "ben.right_leg bens_cylinder ");
  EXPECT_EQ(objects.objects()[2].primitive, Primitive::kCircle);
  EXPECT_EQ(objects.objects()[2].radius_m, 0.25);
  EXPECT_EQ(objects.objects()[3].primitive, Primitive::kLine);
  EXPECT_EQ(objects.objects()[8].primitive, Primitive::kLeg);
  EXPECT_EQ(objects.objects()[8].radius_m, 0.07);
  EXPECT_EQ(objects.objects()[10].label, "mobile_cylinder");
}

TEST(SliceObjectsTest, TheSliceHoldsEachObjectOnceWhereItIs) {
  const SliceObjects objects(world_with_everything());
  PlanarSlice slice;
  objects.slice_at(everything_present(), slice);
  ASSERT_EQ(slice.segments.size(), 5U);
  ASSERT_EQ(slice.discs.size(), 6U);
  std::vector<int> seen(objects.objects().size(), 0);
  for (const SliceSegment& s : slice.segments) ++seen[s.object];
  for (const SliceDisc& d : slice.discs) {
    ++seen[d.object];
    EXPECT_EQ(d.radius_m, objects.objects()[d.object].radius_m);
  }
  EXPECT_EQ(seen, std::vector<int>(11, 1));
  EXPECT_EQ(slice.discs[4].center_m, Vector2d(2, 2));
  EXPECT_EQ(slice.discs[4].object, 9);
  EXPECT_EQ(slice.discs[5].center_m, Vector2d(8, 8));
}

TEST(SliceObjectsTest, ALaserAboveSomebodysHeadMissesThem) {
  World world = world_with_everything();
  world.robot.laser_height_m = 1.3;
  world.walkers[0].height_m = 1.2;
  const SliceObjects objects(world);
  std::string ids;
  for (const SliceObject& object : objects.objects()) ids += object.id + " ";
  EXPECT_EQ(ids, "hall.0 hall.1 column ben.left_leg ben.right_leg ");
  PlanarSlice slice;
  objects.slice_at(everything_present(), slice);
  ASSERT_EQ(slice.discs.size(), 3U);
  EXPECT_EQ(slice.discs[1].center_m, Vector2d(2, 1));
  EXPECT_EQ(slice.discs[1].object, 3);
}

TEST(SliceObjectsTest, WhoIsNotPresentIsNotInTheSlice) {
  const SliceObjects objects(world_with_everything());
  WorldState state = everything_present();
  state.walkers[1].present = false;
  state.tows[1].present = false;
  PlanarSlice slice;
  objects.slice_at(everything_present(), slice);
  objects.slice_at(state, slice);
  ASSERT_EQ(slice.discs.size(), 3U);
  EXPECT_EQ(slice.discs.back().object, 7);
}

TEST(SliceObjectsTest, AnEmptyWorldHasNone) {
  const SliceObjects objects(World{});
  PlanarSlice slice;
  objects.slice_at(WorldState{}, slice);
  EXPECT_TRUE(objects.objects().empty());
  EXPECT_TRUE(slice.segments.empty());
  EXPECT_TRUE(slice.discs.empty());
}

}  // namespace
}  // namespace scanbed::sim
