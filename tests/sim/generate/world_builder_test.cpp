// SPDX-License-Identifier: MIT
#include "sim/generate/world_builder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/world/first_collision.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

TEST(WorldBuilderTest, KeepsThingsClearOfEachOtherTheWallsAndTheRobotsWay) {
  for (int seed = 0; seed < 50; ++seed) {
    WorldBuilder b(seed, "test");
    b.put_hall({5.0, 4.0}, 0.5);
    b.world.robot.X_WR = {{-3.0, 0.0}, 0.0};
    b.let_robot_go(6.0);
    for (int i = 0; i < 10; ++i) b.put_cylinder("column", {0.1, 0.4});
    const auto& solids = b.world.solids;
    ASSERT_GT(solids.size(), 3u);
    for (std::size_t i = 1; i < solids.size(); ++i) {
      const auto& column = std::get<Cylinder>(solids[i].shape);
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GE(clearance_m(solids[k].shape, column.center_m), column.radius_m + 0.3);
      }
      const Edge way{{-3.0, 0.0}, {3.0, 0.0}};
      EXPECT_GE(distance_m(way, column.center_m), column.radius_m + 0.4);
    }
  }
}

TEST(WorldBuilderTest, LeavesOutWhatFitsNowhere) {
  WorldBuilder b(1, "test");
  b.put_hall({1.0, 1.0}, 0.0);
  b.put_cylinder("column", {0.8, 0.9});
  EXPECT_EQ(b.world.solids.size(), 1u);
  Vector2d p_m;
  EXPECT_FALSE(b.place(0.9, p_m));
}

TEST(WorldBuilderTest, LeavesOutPeopleWhoWouldRunIntoSomebody) {
  const auto lane = [](int seed) {
    WorldBuilder b(seed, "test");
    b.rehearsal_s = 10.0;
    b.world.robot.X_WR.p_m = {20, 0};
    b.put_hall({3.4, 0.9}, 0.0);
    return b;
  };
  // So stout and so close to each other that nobody else finds a way, or a place to stand.
  std::vector<Walker> crowd;
  for (const double x_m : {-2.6, -1.3, 0.0, 1.3, 2.6}) {
    Walker stout;
    stout.id = "stout" + std::to_string(crowd.size());
    stout.path.points_m = {{x_m, 0}, {x_m + 0.01, 0}};
    stout.leg_radius_m = 0.6;
    crowd.push_back(stout);
  }
  for (int seed = 0; seed < 20; ++seed) {
    WorldBuilder alone = lane(seed);
    alone.put_walker(seed);
    alone.put_standing_person();
    EXPECT_EQ(alone.world.walkers.size(), 2u) << seed;
    WorldBuilder crowded = lane(seed);
    crowded.world.walkers = crowd;
    EXPECT_FALSE(first_collision(crowded.world, 1.0));
    crowded.put_walker(seed);
    crowded.put_standing_person();
    EXPECT_EQ(crowded.world.walkers.size(), crowd.size()) << seed;
  }
}

TEST(WorldBuilderTest, GivesEachThingAnIdOfItsOwn) {
  WorldBuilder b(1, "test");
  EXPECT_NE(b.next_id("column"), b.next_id("column"));
}

TEST(WorldBuilderTest, APartitionLeavesADoorway) {
  int num_partitions = 0;
  for (int seed = 0; seed < 50; ++seed) {
    WorldBuilder b(seed, "test");
    b.put_hall({5.0, 4.0}, 0.0);
    b.put_robot();
    b.put_partition();
    if (b.world.solids.size() == 1) continue;
    ASSERT_EQ(b.world.solids.size(), 3u);
    ++num_partitions;
    const Vector2d before = std::get<WallChain>(b.world.solids[1].shape).corners_m.at(1);
    const Vector2d behind = std::get<WallChain>(b.world.solids[2].shape).corners_m.at(0);
    EXPECT_EQ(before.x(), behind.x());
    EXPECT_GE((behind - before).norm(), 0.9);
    EXPECT_LE((behind - before).norm(), 1.3);
  }
  EXPECT_GT(num_partitions, 20);
}

}  // namespace
}  // namespace scanbed::sim
