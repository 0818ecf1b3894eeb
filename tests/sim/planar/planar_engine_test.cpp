// SPDX-License-Identifier: MIT
#include "sim/planar/planar_engine.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"
#include "sim/world/drive_plan.hpp"
#include "sim/world/gait.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kBox2dSlop_m = 0.005;  // b2_linearSlop

World hall() {
  World world;
  world.solids.push_back({"hall", "wall", WallChain{{{-7, 0}, {7, 0}, {7, 9}, {-7, 9}}, true}, 0, 2.5, {}});
  world.solids.push_back({"column", "column", Cylinder{{-2, 4}, 0.25}, 0, 2.5, {}});
  Walker anna;
  anna.id = "anna";
  anna.path = {{{-3.2, 2.8}, {3.2, 2.8}, {3.2, 5.2}, {-3.2, 5.2}}, true, 0.6, false};
  anna.speed_m_per_s = 1.0;
  anna.tow = Tow{};
  anna.tow->id = "cyl";
  world.walkers.push_back(anna);
  Walker ben;
  ben.id = "ben";
  ben.path = {{{6.6, 2.4}, {4.6, 0.6}}, false, 0.0, true};
  ben.start_s = 2.0;
  world.walkers.push_back(ben);
  world.robot.X_WR = {{0, 0.45}, kPi / 2};
  world.robot.drive = {Wait{1}, Go{1}, Turn{-1}};
  return world;
}

TEST(PlanarEngineTest, RobotAndWalkersFollowTheirScriptsExactly) {
  const World world = hall();
  PlanarEngine engine(world);
  const DrivePlan drive(world.robot);
  const Gait gait(world.walkers[0], 0, world.robot.laser_height_m);
  for (const double t_s : {0.0, 0.5, 1.0 / 3, 2.7, 9.99}) {
    if (t_s < engine.state().time_s) continue;
    engine.advance_to(t_s);
    EXPECT_EQ(engine.state().time_s, t_s);
    EXPECT_EQ(engine.state().X_WR.p_m, drive.pose_at(t_s).p_m);
    EXPECT_EQ(engine.state().walkers[0].left_leg_m, gait.state_at(t_s).left_leg_m);
    EXPECT_EQ(engine.slice().discs.at(1).center_m, gait.state_at(t_s).left_leg_m);
  }
}

TEST(PlanarEngineTest, TheCylinderFollowsWithinItsRopeForAMinute) {
  PlanarEngine engine(hall());
  Vector2d last_m = engine.state().tows.at(0).center_m;
  double way_m = 0.0;
  for (int k = 1; k <= 600; ++k) {
    engine.advance_to(0.1 * k);
    const Vector2d center_m = engine.state().tows.at(0).center_m;
    // The pelvis is 1 m/s / 300 ahead of the rope at most.
    ASSERT_LE((center_m - engine.state().walkers[0].X_WP.p_m).norm(), 1.15 + kBox2dSlop_m + 1.0 / 300) << k;
    way_m += (center_m - last_m).norm();
    last_m = center_m;
  }
  EXPECT_GT(way_m, 50.0);  // of the 60 m that the walker went; it cuts corners
}

TEST(PlanarEngineTest, WalkersComeAndGo) {
  PlanarEngine engine(hall());
  EXPECT_FALSE(engine.state().walkers[1].present);
  EXPECT_EQ(engine.slice().discs.size(), 4U);  // column, two legs, cylinder
  engine.advance_to(2.5);
  EXPECT_TRUE(engine.state().walkers[1].present);
  EXPECT_EQ(engine.slice().discs.size(), 6U);
  engine.advance_to(2.0 + std::hypot(2.0, 1.8) / 1.37 + 0.01);
  EXPECT_FALSE(engine.state().walkers[1].present);
  EXPECT_EQ(engine.slice().discs.size(), 4U);
}

TEST(PlanarEngineTest, WhereThingsAreDoesNotDependOnTheTimesAskedFor) {
  PlanarEngine at_once(hall());
  PlanarEngine often(hall());
  for (double part = 0.0; part < 1.0; part += 0.0137) often.advance_to(part * 12.345);
  often.advance_to(12.345);
  at_once.advance_to(12.345);
  EXPECT_EQ(at_once.state().tows.at(0).center_m, often.state().tows.at(0).center_m);
  at_once.advance_to(12.345);  // the same time again is fine
  EXPECT_EQ(at_once.state().tows.at(0).center_m, often.state().tows.at(0).center_m);
}

TEST(PlanarEngineTest, BetweenStepsTheCylinderMovesStraight) {
  PlanarEngine engine(hall());
  const auto cylinder_at = [&](double t_s) {
    engine.advance_to(t_s);
    return engine.state().tows.at(0).center_m;
  };
  const Vector2d a = cylinder_at(900.0 / 300);
  const Vector2d middle = cylinder_at(900.5 / 300);
  const Vector2d b = cylinder_at(901.0 / 300);
  EXPECT_GT((b - a).norm(), 0.001);
  EXPECT_NEAR((middle - 0.5 * (a + b)).norm(), 0.0, 1e-9);
}

TEST(PlanarEngineTest, LegsPushACylinderThatLiesInTheWay) {
  World world;
  Walker anna;
  anna.id = "anna";
  anna.path.points_m = {{0, 3},
                        {0, 4}};  // walks a metre, then stands; the cylinder comes to rest near (0, 3)
  anna.tow = Tow{};
  anna.tow->id = "cyl";
  world.walkers.push_back(anna);
  Walker ben;
  ben.id = "ben";
  ben.path.points_m = {{-4, 3}, {4, 3}};
  ben.start_s = 3.0;
  world.walkers.push_back(ben);
  world.robot.X_WR = {{0, -5}, 0.0};
  PlanarEngine engine(world);
  engine.advance_to(3.0);
  const Vector2d before_m = engine.state().tows[0].center_m;
  double deepest_m = 0.0;
  for (int k = 0; k <= 700; ++k) {
    engine.advance_to(3.0 + 0.01 * k);
    const WalkerState& b = engine.state().walkers[1];
    for (const Vector2d& leg : {b.left_leg_m, b.right_leg_m}) {
      const double gap_m = (leg - engine.state().tows[0].center_m).norm() - 0.25 - 0.06;
      deepest_m = std::max(deepest_m, -gap_m);
    }
  }
  EXPECT_GT((engine.state().tows[0].center_m - before_m).norm(), 0.1);
  // A shin moves up to 2.8 m/s / 300 = 9.4 mm into it before the next step answers.
  EXPECT_LT(deepest_m, 3 * 0.0094 + kBox2dSlop_m);
}

TEST(PlanarEngineTest, AWorldWithoutMovingThingsStandsStill) {
  World world = hall();
  world.walkers.clear();
  world.robot.drive.clear();
  PlanarEngine engine(world);
  engine.advance_to(1e6);
  EXPECT_EQ(engine.slice().segments.size(), 4U);
  EXPECT_EQ(engine.slice().discs.size(), 1U);
  EXPECT_TRUE(engine.state().tows.empty());
}

TEST(PlanarEngineTest, RefusesWorldsThatCannotBe) {
  World world = hall();
  world.walkers[0].tow->rope_m = 0.0;
  EXPECT_THROW(PlanarEngine{world}, InputError);
}

TEST(PlanarEngineTest, RefusesALaserThatIsTilted) {
  World world = hall();
  world.robot.laser_pitch_rad = 0.1;
  EXPECT_THROW(PlanarEngine{world}, InputError);
  world.robot.laser_pitch_rad = 0.0;
  world.robot.laser_roll_rad = -0.1;
  EXPECT_THROW(PlanarEngine{world}, InputError);
}

TEST(PlanarEngineTest, TheSliceIsInTheWorldFrameAndTheSensorInIt) {
  World world = hall();
  world.robot.X_RS = {{0.1, 0.0}, 0.25};
  PlanarEngine engine(world);
  EXPECT_NEAR((engine.sensor_in_plane().p_m - Vector2d(0.0, 0.55)).norm(), 0.0,
              1e-12);  // the robot looks along y
  EXPECT_NEAR(engine.sensor_in_plane().theta_rad, kPi / 2 + 0.25, 1e-12);
  EXPECT_EQ(engine.slice().segments.at(0).a_m, Vector2d(-7, 0));
}

TEST(PlanarEngineTest, TimeDoesNotRunBackwards) {
  PlanarEngine engine(hall());
  engine.advance_to(1.0);
  EXPECT_DEATH(engine.advance_to(0.5), "broken promise");
  EXPECT_DEATH(engine.advance_to(std::nan("")), "broken promise");
}

}  // namespace
}  // namespace scanbed::sim
