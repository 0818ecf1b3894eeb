// SPDX-License-Identifier: MIT
#include "sim/world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// A hall with one solid of each kind, a walker who tows, and a robot that drives.
World hall() {
  World world;
  world.solids.push_back({"hall", "wall", WallChain{{{-7, 0}, {7, 0}, {7, 9}, {-7, 9}}, true}, 0, 2.5, {}});
  world.solids.push_back({"column", "column", Cylinder{{-2, 4}, 0.25}, 0, 2.5, {}});
  world.solids.push_back({"box", "box", Box{{{3, 7}, 0.3}, {1, 0.5}}, 0, 0.5, {}});
  world.solids.push_back({"wedge", "box", Polygon{{{5, 7}, {6, 7}, {5, 8}}}, 0, 1, {}});
  Walker walker;
  walker.id = "anna";
  walker.path = {{{-3, 2}, {3, 2}, {3, 5}, {-3, 5}}, true, 0.5, false};
  walker.tow = Tow{};
  walker.tow->id = "cyl";
  world.walkers.push_back(walker);
  world.robot.X_WR = {{0, 0.45}, kPi / 2};
  world.robot.drive = {Wait{1}, Turn{0.5}, Go{1}};
  return world;
}

void expect_refused(const std::function<void(World&)>& spoil, const std::string& words) {
  World world = hall();
  spoil(world);
  try {
    world.validate();
    ADD_FAILURE() << "accepted; expected: " << words;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(words, 0), 0U) << message;
    EXPECT_NE(message.find("allowed: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(WorldTest, AcceptsAHallAndAnEmptyWorld) {
  EXPECT_NO_THROW(hall().validate());
  EXPECT_NO_THROW(World{}.validate());
}

TEST(WorldTest, NamesTheSolidAndTheFieldThatCannotBe) {
  expect_refused([](World& w) { std::get<WallChain>(w.solids[0].shape).corners_m.resize(2); },
                 "solid 'hall': number of corners: value 2");
  expect_refused([](World& w) { std::get<WallChain>(w.solids[0].shape).corners_m[1].x() = kNan; },
                 "solid 'hall': corner: value nan");
  expect_refused([](World& w) { std::get<WallChain>(w.solids[0].shape).corners_m[1] = Vector2d(-7, 0); },
                 "solid 'hall': length of the edge that ends at corner 1: value 0");
  expect_refused([](World& w) { std::get<Cylinder>(w.solids[1].shape).radius_m = 0; },
                 "solid 'column': radius_m: value 0");
  expect_refused([](World& w) { std::get<Cylinder>(w.solids[1].shape).radius_m = kInf; },
                 "solid 'column': radius_m: value inf");
  expect_refused([](World& w) { std::get<Cylinder>(w.solids[1].shape).center_m.y() = 1e9; },
                 "solid 'column': center: value 1000000000");
  expect_refused([](World& w) { std::get<Box>(w.solids[2].shape).size_m.y() = -1; },
                 "solid 'box': size_m along y: value -1");
  expect_refused([](World& w) { std::get<Box>(w.solids[2].shape).X_WB.theta_rad = kNan; },
                 "solid 'box': angle_rad: value nan");
  expect_refused([](World& w) { w.solids[2].top_m = w.solids[2].bottom_m; }, "solid 'box': top_m: value 0");
  expect_refused([](World& w) { w.solids[2].bottom_m = -kInf; }, "solid 'box': bottom_m: value -inf");
  expect_refused([](World& w) { w.solids[1].material.reflectivity = 1.5; },
                 "solid 'column': reflectivity: value 1.5");
  expect_refused([](World& w) { w.solids[1].material.roughness_m = -1; },
                 "solid 'column': roughness_m: value -1");
}

TEST(WorldTest, RefusesPolygonsThatAreNotConvexAndCounterClockwise) {
  const auto shape = [](std::vector<Vector2d> corners_m) {
    return [corners_m](World& w) { w.solids[3].shape = Polygon{corners_m}; };
  };
  expect_refused(shape({{5, 7}, {5, 8}, {6, 7}}), "solid 'wedge': turn_rad at corner 0");
  expect_refused(shape({{5, 7}, {6, 7}, {5.2, 7.2}, {5, 8}}), "solid 'wedge': turn_rad at corner 2");
  expect_refused(shape({{5, 7}, {6, 7}}), "solid 'wedge': number of corners: value 2");
  std::vector<Vector2d> star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(5.5 + 0.5 * std::cos(0.8 * kPi * i), 7.5 + 0.5 * std::sin(0.8 * kPi * i));
  expect_refused(shape(star), "solid 'wedge': turns of the outline: value 2");
}

TEST(WorldTest, RefusesIdsThatAreNotTheirOwn) {
  expect_refused([](World& w) { w.solids[1].id = ""; }, "solid '': id: is empty");
  expect_refused([](World& w) { w.solids[1].id = "box"; }, "solid 'box': id: 'box' is taken");
  expect_refused([](World& w) { w.solids[1].id = "hall.2"; }, "solid 'hall.2': id: 'hall.2' is taken");
  expect_refused([](World& w) { w.walkers[0].id = "hall"; }, "walker 'hall': id: 'hall' is taken");
  expect_refused([](World& w) { w.walkers[0].tow->id = "anna"; },
                 "towed cylinder 'anna': id: 'anna' is taken");
  expect_refused([](World& w) { w.solids[1].id = "anna.left_leg"; }, "walker 'anna': id: 'anna.left_leg'");
  expect_refused([](World& w) { w.solids[1].id = "anna.body"; }, "walker 'anna': id: 'anna.body'");
  expect_refused([](World& w) { w.solids[1].id = "hall.top"; }, "solid 'hall.top': id: 'hall.top' is taken");
  expect_refused([](World& w) { w.solids[1].id = "floor"; }, "solid 'floor': id: 'floor' is taken");
}

TEST(WorldTest, NamesTheWalkerAndTheFieldThatCannotBe) {
  expect_refused([](World& w) { w.walkers[0].path.points_m.resize(1); },
                 "walker 'anna': path: number of points: value 1");
  expect_refused(
      [](World& w) {
        w.walkers[0].path = {{{2000, 0}, {1, 1}}, false, 0, false};
      },
      "walker 'anna': path: value 2000");
  expect_refused([](World& w) { w.walkers[0].speed_m_per_s = 0; }, "walker 'anna': speed_m_per_s: value 0");
  expect_refused([](World& w) { w.walkers[0].start_s = -1; }, "walker 'anna': start_s: value -1");
  expect_refused([](World& w) { w.walkers[0].leg_radius_m = kNan; }, "walker 'anna': leg_radius_m");
  expect_refused([](World& w) { w.walkers[0].leg_length_m = 0; }, "walker 'anna': leg_length_m");
  expect_refused([](World& w) { w.walkers[0].step_width_m = -0.1; }, "walker 'anna': step_width_m");
  expect_refused([](World& w) { w.walkers[0].height_m = 0; }, "walker 'anna': height_m");
  expect_refused([](World& w) { w.walkers[0].lateral_m = kNan; }, "walker 'anna': lateral_m");
  expect_refused([](World& w) { w.walkers[0].stops = {{.at_m = -1}}; }, "walker 'anna': stop 0: at_m");
  expect_refused(
      [](World& w) {
        w.walkers[0].stops = {{.at_m = 1}, {.at_m = 1}};
      },
      "walker 'anna': stop 1: at_m");
  expect_refused(
      [](World& w) {
        w.walkers[0].path = {{{0, 1}, {3, 1}, {3, 5}}, false, 0, false};
        w.walkers[0].stops = {{.at_m = 7.0}, {.at_m = 7.1}};
      },
      "walker 'anna': stop 1: at_m: value 7.1 is out of range; allowed: at most 7");
  expect_refused([](World& w) { w.walkers[0].stops = {{.for_s = 0.5}}; }, "walker 'anna': stop 0: for_s");
  expect_refused([](World& w) { w.walkers[0].stops = {{.turn_rad = 7}}; }, "walker 'anna': stop 0: turn_rad");
  expect_refused([](World& w) { w.walkers[0].material.reflectivity = 0; }, "walker 'anna': reflectivity");
  expect_refused([](World& w) { w.walkers[0].tow->material.roughness_m = 2; },
                 "towed cylinder 'cyl': roughness_m");
  expect_refused([](World& w) { w.walkers[0].tow->rope_m = 0; }, "towed cylinder 'cyl': rope_m: value 0");
  expect_refused([](World& w) { w.walkers[0].tow->radius_m = -1; }, "towed cylinder 'cyl': radius_m");
  expect_refused([](World& w) { w.walkers[0].tow->height_m = 0; }, "towed cylinder 'cyl': height_m");
  expect_refused([](World& w) { w.walkers[0].tow->mass_kg = 0; }, "towed cylinder 'cyl': mass_kg");
  expect_refused([](World& w) { w.walkers[0].tow->friction = kNan; }, "towed cylinder 'cyl': friction");
}

TEST(WorldTest, NamesTheFieldOfTheRobotThatCannotBe) {
  expect_refused([](World& w) { w.robot.X_WR.p_m.x() = kInf; }, "robot: position: value inf");
  expect_refused([](World& w) { w.robot.X_RS.theta_rad = kNan; }, "robot: laser: angle_rad");
  expect_refused([](World& w) { w.robot.laser_height_m = 0; }, "robot: laser_height_m: value 0");
  expect_refused([](World& w) { w.robot.speed_m_per_s = 0; }, "robot: speed_m_per_s");
  expect_refused([](World& w) { w.robot.turn_rad_per_s = -1; }, "robot: turn_rad_per_s");
  expect_refused([](World& w) { w.robot.radius_m = 0; }, "robot: radius_m");
  expect_refused([](World& w) { w.robot.laser_pitch_rad = 1.5; }, "robot: laser_pitch_rad: value 1.5");
  expect_refused([](World& w) { w.robot.laser_roll_rad = kNan; }, "robot: laser_roll_rad: value nan");
  expect_refused([](World& w) { w.robot.drive[0] = Wait{-1}; }, "robot: drive step 0: wait: value -1");
  expect_refused([](World& w) { w.robot.drive[1] = Turn{kNan}; }, "robot: drive step 1: turn");
  expect_refused([](World& w) { w.robot.drive[2] = Go{kInf}; }, "robot: drive step 2: go: value inf");
}

TEST(WorldTest, NobodyStartsInsideASolid) {
  expect_refused([](World& w) { w.robot.X_WR.p_m = {-2, 4.1}; }, "robot: start: distance to solid 'column'");
  expect_refused([](World& w) { w.robot.X_WR.p_m = {0, 0.1}; }, "robot: start: distance to solid 'hall'");
  expect_refused(
      [](World& w) {
        w.walkers[0].path = {{{3, 7}, {3, 2}}, false, 0, false};
      },
      "walker 'anna': start of its path: distance to solid 'box'");
  expect_refused(
      [](World& w) {
        w.walkers[0].path = {{{-3, 2}, {5.2, 7.2}}, false, 0.0, false};
      },
      "walker 'anna': path point 1: distance to solid 'wedge'");
  expect_refused(
      [](World& w) {
        w.walkers[0].path = {{{-5.9, 2}, {3, 2}, {3, 5}}, true, 0, false};
      },
      "towed cylinder 'cyl': start, a rope's length behind its walker: distance to solid 'hall'");
}

TEST(WorldTest, NoRopeStartsThroughAWall) {
  expect_refused(
      [](World& w) {
        w.walkers[0].path = {{{-6.5, 2}, {3, 2}, {3, 5}}, true, 0, false};
      },
      "towed cylinder 'cyl': start, a rope's length behind its walker: rope through solid 'hall'");
}

TEST(WorldTest, WhatHangsAboveIsNotInTheWay) {
  World world = hall();
  world.solids.push_back({"seat", "bench", Box{{{0, 0.45}, 0}, {1, 1}}, 0.4, 0.45, {}});
  EXPECT_NO_THROW(world.validate());
}

}  // namespace
}  // namespace scanbed::sim
