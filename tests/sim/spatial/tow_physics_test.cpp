// SPDX-License-Identifier: MIT
#include "sim/spatial/tow_physics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/spatial/mjcf.hpp"
#include "sim/world/world_script.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class TowPhysicsTest : public ::testing::Test {
 protected:
  TowPhysicsTest() {
    world_.walkers = {
        {.id = "ann", .path = {{{0, 0}, {40, 0}}}, .speed_m_per_s = 1.0, .tow = Tow{.id = "cyl"}}};
    world_.robot.X_WR = {{0, 5}, 0.0};
  }

  void start() {
    script_.emplace(world_);
    model_ = load_model(mjcf_of(world_));
    script_->follow(0.0, state_);
    physics_.emplace(world_, *model_, state_);
    num_steps_ = 0;
  }
  void run_to(double time_s) {
    while (num_steps_ * TowPhysics::kStep_s < time_s - 1e-9) {
      script_->follow(++num_steps_ * TowPhysics::kStep_s, state_);
      physics_->step_to(state_);
    }
  }
  Vector3d place() const { return physics_->places().at(0); }

  World world_;
  std::optional<WorldScript> script_;
  ModelPtr model_;
  WorldState state_;
  std::optional<TowPhysics> physics_;
  int num_steps_ = 0;
};

TEST_F(TowPhysicsTest, StartsARopesLengthBehindItsWalker) {
  start();
  EXPECT_NEAR((place() - Vector3d(-1.15, 0, 0)).norm(), 0.0, 1e-12);
}

// MuJoCo's contacts and limits give way a little: some millimetres of rope under mu m g = 24 N, and of floor
// when the rope jerks. Its contacts with a cylinder's rim wander, and so does the cylinder to either side.
TEST_F(TowPhysicsTest, FollowsOnATautRopeUprightOnTheFloor) {
  start();
  for (int k = 2; k <= 20; ++k) {
    run_to(0.5 * k);
    EXPECT_NEAR(state_.walkers[0].X_WP.p_m.x() - place().x(), 1.15, 0.01) << k;
    EXPECT_NEAR(place().y(), 0.0, 0.03);
    EXPECT_NEAR(place().z(), 0.0, 0.005);
  }
}

// Coulomb: without the pull it stops after v^2 / (2 mu g), however heavy it is.
TEST_F(TowPhysicsTest, SlidesOnAsCoulombSaysWhenTheWalkerStops) {
  for (const double mass_kg : {2.0, 20.0}) {
    world_.walkers[0].path.points_m = {{0, 0}, {3, 0}};
    world_.walkers[0].speed_m_per_s = 2.0;
    world_.walkers[0].tow->mass_kg = mass_kg;
    start();
    run_to(1.5);
    const double moving_m = place().x();
    run_to(3.0);
    EXPECT_NEAR(place().x() - moving_m, 2.0 * 2.0 / (2.0 * 0.3 * 9.81), 0.02) << mass_kg;
    const Vector3d there_m = place();
    run_to(5.0);
    EXPECT_NEAR((place() - there_m).norm(), 0.0, 0.005) << mass_kg;
  }
}

// Without the wall it would slide on for 0.68 m, to x = 2.53.
TEST_F(TowPhysicsTest, AWallStopsIt) {
  world_.solids = {{.id = "wall", .label = "wall", .shape = WallChain{{{2.4, -2}, {2.4, 2}}}}};
  world_.walkers[0].path.points_m = {{0, 0}, {3, 0}};
  world_.walkers[0].speed_m_per_s = 2.0;
  start();
  run_to(1.5);
  EXPECT_LT(place().x(), 1.9);
  double farthest_m = 0.0;
  for (int k = 0; k <= 50; ++k) {
    run_to(1.5 + 0.05 * k);
    farthest_m = std::max(farthest_m, place().x());
  }
  // Half the wall's thickness and the cylinder's radius before it.
  EXPECT_NEAR(farthest_m, 2.4 - 0.03 - 0.25, 0.02);
}

TEST_F(TowPhysicsTest, ComesAndGoesWithItsWalker) {
  world_.walkers[0].start_s = 0.5;
  world_.walkers[0].path = {{{0, 0}, {1, 0}}, false, 0.0, true};
  start();
  EXPECT_GT(place().z(), 100.0);
  run_to(0.45);
  EXPECT_GT(place().z(), 100.0);
  run_to(1.0);
  EXPECT_NEAR(place().z(), 0.0, 0.005);
  EXPECT_NEAR(place().x(), -0.65, 0.02);
  run_to(1.6);
  EXPECT_GT(place().z(), 100.0);
}

TEST_F(TowPhysicsTest, AWalkerInItsWayPushesIt) {
  world_.walkers.push_back(
      {.id = "ben", .path = {{{-1.15, 3}, {-1.15, -3}}}, .speed_m_per_s = 1.0, .step_width_m = 0.1});
  world_.walkers[0].start_s = 0.0;
  world_.walkers[0].path.points_m = {{0, 0}, {0.01, 0}};  // stands still
  start();
  run_to(6.0);
  EXPECT_GT((place().head<2>() - Vector2d(-1.15, 0)).norm(), 0.1);
}

}  // namespace
}  // namespace scanbed::sim
