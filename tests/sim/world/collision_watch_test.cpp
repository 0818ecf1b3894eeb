// SPDX-License-Identifier: MIT
#include "sim/world/collision_watch.hpp"

#include <gtest/gtest.h>

#include "tests/sim/world/made_solid.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using testing::made_solid;

constexpr double kFar_m = 50.0;

Walker walker(const std::string& id, double leg_radius_m) {
  Walker made;
  made.id = id;
  made.leg_radius_m = leg_radius_m;
  return made;
}

/// Robot of radius 0.22 m at the origin, two walkers far off.
class CollisionWatchTest : public ::testing::Test {
 protected:
  CollisionWatchTest() {
    world_.walkers = {walker("ann", 0.06), walker("ben", 0.05)};
    state_.walkers.resize(2);
    for (int i = 0; i < 2; ++i) {
      state_.walkers[i].walker = i;
      state_.walkers[i].present = true;
      put_legs(i, {kFar_m, 10.0 * i}, {kFar_m, 10.0 * i + 0.3});
    }
  }

  void put_legs(int walker, const Vector2d& left_m, const Vector2d& right_m) {
    state_.walkers[walker].left_leg_m = left_m;
    state_.walkers[walker].right_leg_m = right_m;
  }

  // What is found in the state alone.
  std::vector<Collision> look() const {
    CollisionWatch watch(world_);
    watch.look(state_);
    return watch.collisions();
  }

  World world_;
  WorldState state_;
};

TEST_F(CollisionWatchTest, NothingMeetsInAnEmptyWorld) {
  EXPECT_TRUE(look().empty());
}

TEST_F(CollisionWatchTest, TheRobotMeetsSolidsCloserThanItsRadius) {
  const SolidShape shapes[] = {Cylinder{{0.5, 0}, 0.29}, Box{{{0.5, 0}, 0.0}, {0.58, 1}},
                               Polygon{{{0.21, -1}, {1, -1}, {1, 1}, {0.21, 1}}},
                               WallChain{{{0.21, -1}, {0.21, 1}}, false}};
  for (const SolidShape& shape : shapes) {
    world_.solids = {made_solid("thing", shape)};
    state_.X_WR.p_m = {0, 0};
    EXPECT_EQ(look(), (std::vector<Collision>{{0.0, "robot", "thing"}}));
    state_.X_WR.p_m = {-0.02, 0};
    EXPECT_TRUE(look().empty());
  }
}

TEST_F(CollisionWatchTest, TheRobotPassesBelowWhatHangsAboveItsLaser) {
  world_.solids = {made_solid("seat", Box{{{0, 0}, 0.0}, {1, 1}}, 0.4, 0.5)};
  EXPECT_TRUE(look().empty());
  world_.solids[0].bottom_m = 0.2;
  EXPECT_EQ(look().size(), 1u);
}

TEST_F(CollisionWatchTest, LegsMeetTheRobotSolidsAndEachOther) {
  world_.solids = {made_solid("wall", WallChain{{{20, -9}, {20, 9}}, false})};
  put_legs(0, {0.27, 0}, {20.05, 1});
  put_legs(1, {20.0, 1.2}, {20.05, 1.1});
  EXPECT_EQ(look(),
            (std::vector<Collision>{
                {0.0, "robot", "ann"}, {0.0, "ann", "wall"}, {0.0, "ann", "ben"}, {0.0, "ben", "wall"}}));
}

TEST_F(CollisionWatchTest, WhoIsAbsentMeetsNothing) {
  put_legs(0, {0, 0}, {0, 0});
  put_legs(1, {0, 0}, {0, 0});
  state_.walkers[0].present = false;
  EXPECT_EQ(look(), (std::vector<Collision>{{0.0, "robot", "ben"}}));
}

TEST_F(CollisionWatchTest, OwnLegsMayTouch) {
  put_legs(0, {5, 5}, {5, 5.05});
  EXPECT_TRUE(look().empty());
}

TEST_F(CollisionWatchTest, TheRobotMeetsATowedCylinderButItsWalkerPushesIt) {
  world_.walkers[1].tow = Tow{.id = "bin", .radius_m = 0.25};
  state_.tows = {{1, true, {0.46, 0}}};
  put_legs(1, {0.6, 0}, {0.7, 0});
  EXPECT_EQ(look(), (std::vector<Collision>{{0.0, "robot", "bin"}}));
}

// Its rope of 0.9 m reaches 1.15 m from ben to its axis.
TEST_F(CollisionWatchTest, ATowedCylinderThatIsStuckMeetsWhatHoldsIt) {
  world_.walkers[1].tow = Tow{.id = "bin", .radius_m = 0.25, .height_m = 1.0, .rope_m = 0.9};
  world_.solids = {made_solid("wall", WallChain{{{5.27, -9}, {5.27, 9}}, false})};
  state_.tows = {{1, true, {5, 0}}};
  state_.walkers[1].X_WP.p_m = {6.2, 0};
  EXPECT_TRUE(look().empty());  // it rubs along the wall
  state_.walkers[1].X_WP.p_m = {6.4, 0};
  EXPECT_EQ(look(), (std::vector<Collision>{{0.0, "bin", "wall"}}));
  world_.solids[0].bottom_m = 1.1;  // hangs above it
  EXPECT_TRUE(look().empty());
  world_.solids[0].bottom_m = 0.0;
  state_.tows[0].center_m = {3, 0};  // held by something else
  EXPECT_TRUE(look().empty());
}

TEST_F(CollisionWatchTest, ATowedCylinderThatIsPulledThroughAWallMeetsIt) {
  world_.walkers[1].tow = Tow{.id = "bin", .radius_m = 0.25};
  world_.solids = {made_solid("wall", WallChain{{{5.2, -9}, {5.2, 9}}, false})};
  state_.tows = {{1, true, {5, 0}}};
  state_.walkers[1].X_WP.p_m = {6.0, 0};
  EXPECT_EQ(look(), (std::vector<Collision>{{0.0, "bin", "wall"}}));
}

TEST_F(CollisionWatchTest, PartingForLessThanASecondIsOneMeeting) {
  world_.solids = {made_solid("post", Cylinder{{1, 0}, 0.1})};
  CollisionWatch watch(world_);
  const auto look_at = [&](double time_s, double x_m) {
    state_.time_s = time_s;
    state_.X_WR.p_m = {x_m, 0};
    watch.look(state_);
  };
  look_at(0.0, 0.0);
  look_at(1.0, 0.8);
  look_at(1.9, 0.5);
  look_at(1.99, 0.8);
  look_at(3.5, 0.8);
  EXPECT_EQ(watch.collisions(), (std::vector<Collision>{{1.0, "robot", "post"}, {3.5, "robot", "post"}}));
}

TEST_F(CollisionWatchTest, LooksAtEachOfTwentyTimesASecond) {
  world_.solids = {made_solid("post", Cylinder{{1, 0}, 0.1})};
  for (int meeting = 1; meeting < 100; ++meeting) {
    CollisionWatch watch(world_);
    for (int k = 0; k <= 100; ++k) {
      state_.time_s = k / 20.0;
      state_.X_WR.p_m = {k == meeting ? 0.8 : 0.0, 0};
      watch.look(state_);
    }
    EXPECT_EQ(watch.collisions(), (std::vector<Collision>{{meeting / 20.0, "robot", "post"}}));
  }
}

}  // namespace
}  // namespace scanbed::sim
