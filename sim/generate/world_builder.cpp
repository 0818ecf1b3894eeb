// SPDX-License-Identifier: MIT
#include "sim/generate/world_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angles.hpp"
#include "core/geometry/polar.hpp"
#include "sim/world/body.hpp"
#include "sim/world/first_collision.hpp"
#include "sim/world/furniture.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kMinGap_m = 0.3;  // between things that stand free
constexpr double kRobotClearance_m = 0.4;
constexpr double kPersonRoom_m = 0.4;
constexpr int kTrials = 40;

}  // namespace

void WorldBuilder::add(const char* label, SolidShape shape) {
  world.solids.push_back({.id = next_id(label), .label = label, .shape = std::move(shape)});
}

bool WorldBuilder::is_clear(const Vector2d& p_m, double radius_m) const {
  return std::all_of(world.solids.begin(), world.solids.end(),
                     [&](const Solid& solid) { return clearance_m(solid.shape, p_m) >= radius_m; });
}

bool WorldBuilder::is_clear_way(const Vector2d& from_m, const Vector2d& to_m, double radius_m) const {
  constexpr double kStep_m = 0.1;
  const int num_steps = static_cast<int>((to_m - from_m).norm() / kStep_m) + 1;
  for (int i = 0; i <= num_steps; ++i) {
    const Vector2d p_m = from_m + (to_m - from_m) * i / num_steps;
    if (!is_clear(p_m, radius_m) || distance_to_robot_m(p_m) < radius_m + kRobotClearance_m) return false;
  }
  return true;
}

double WorldBuilder::distance_to_robot_m(const Vector2d& p_m) const {
  const Pose2& X_WR = world.robot.X_WR;
  return distance_m(Edge{X_WR.p_m, X_WR * Vector2d(way_m_, 0.0)}, p_m);
}

bool WorldBuilder::place(double radius_m, Vector2d& p_m) {
  for (int trial = 0; trial < kTrials; ++trial) {
    p_m = {dice.uniform(-half_m.x(), half_m.x()), dice.uniform(-half_m.y(), half_m.y())};
    const bool is_inside = (half_m - p_m.cwiseAbs()).minCoeff() > radius_m + kMinGap_m;
    const bool is_near_robot = distance_to_robot_m(p_m) < radius_m + kRobotClearance_m;
    if (is_inside && !is_near_robot && is_clear(p_m, radius_m + kMinGap_m)) return true;
  }
  return false;
}

void WorldBuilder::put_hall(const Vector2d& half_size_m, double niche_chance) {
  half_m = half_size_m;
  const WallNiches niches{.chance = niche_chance,
                          .first = {0.5, 2.0},
                          .next = {1.8, 3.5},
                          .last_m = 2.0,
                          .width = {0.8, 1.2},
                          .depth = {0.1, 0.35}};
  add("wall", hall_outline(half_m, niches, dice));
}

void WorldBuilder::put_partition() {
  constexpr double kRoom_m = 1.0;  // between robot and partition
  const double x_m = dice.uniform(-0.5, 0.5) * half_m.x();
  const double door_m = dice.uniform(0.9, 1.3);
  const double from_m = dice.uniform(-half_m.y() + 0.5, half_m.y() - 0.5 - door_m);
  if (std::abs(x_m - world.robot.X_WR.p_m.x()) < kRoom_m) return;
  add("wall", WallChain{{{x_m, -half_m.y()}, {x_m, from_m}}, false});
  add("wall", WallChain{{{x_m, from_m + door_m}, {x_m, half_m.y()}}, false});
}

void WorldBuilder::put_robot() {
  const double y_m = dice.uniform(-0.7, 0.7) * half_m.y();
  const double x_m = dice.uniform(-0.7, 0.7) * half_m.x();
  const double ahead_rad = x_m > 0.0 ? kPi : 0.0;
  world.robot.X_WR = {{x_m, y_m}, wrap_to_pi(ahead_rad + dice.uniform(-1.2, 1.2))};
}

void WorldBuilder::let_robot_go(double distance_m) {
  way_m_ = distance_m;
  world.robot.drive = {Go{distance_m}};
}

void WorldBuilder::put_cylinder(const char* label, const LengthRange& radius) {
  const double radius_m =
      radius.least_m * std::pow(radius.greatest_m / radius.least_m, dice.uniform(0.0, 1.0));
  Vector2d p_m;
  if (place(radius_m, p_m)) add(label, Cylinder{p_m, radius_m});
}

void WorldBuilder::put_box(const char* label, const LengthRange& size, double max_aspect) {
  const double a_m = dice.uniform(size.least_m, size.greatest_m);
  const double b_m = std::min(a_m * dice.uniform(1.0, max_aspect), 2.0 * size.greatest_m);
  Vector2d p_m;
  if (!place(std::hypot(a_m, b_m) / 2, p_m)) return;
  add(label, Box{{p_m, dice.uniform(-kPi, kPi)}, {a_m, b_m}});
}

void WorldBuilder::put_chair() {
  Vector2d p_m;
  if (!place(0.4, p_m)) return;
  const Pose2 X_WC{p_m, dice.uniform(-kPi, kPi)};
  for (Solid& part : chair_parts({.id = next_id("chair"), .X_WC = X_WC})) world.solids.push_back(part);
}

void WorldBuilder::put_bench() {
  const double radius_m = dice.uniform(0.15, 0.3);
  const Bench sizes{.foot_radius_m = radius_m};
  Vector2d p_m;
  if (!place(0.5 * sizes.feet_apart_m + radius_m, p_m)) return;
  Bench bench = sizes;
  bench.id = next_id("bench");
  bench.X_WB = {p_m, dice.uniform(-kPi, kPi)};
  for (Solid& part : bench_parts(bench)) world.solids.push_back(part);
}

bool WorldBuilder::let_walk(const Walker& walker) {
  world.walkers.push_back(walker);
  if (rehearsal_s <= 0.0 || !first_collision(world, rehearsal_s)) return true;
  world.walkers.pop_back();
  return false;
}

void WorldBuilder::put_standing_person() {
  for (int trial = 0; trial < kTrials; ++trial) {
    Vector2d p_m;
    if (!place(kPersonRoom_m, p_m)) return;
    const Vector2d along_m = polar(dice.uniform(-kPi, kPi), 0.3);
    Walker walker;
    walker.id = next_id("person");
    walker.path.points_m = {p_m, p_m + along_m};
    walker.leg_radius_m = dice.uniform(0.045, 0.075);
    if (let_walk(walker)) return;
  }
}

void WorldBuilder::put_walker(std::uint64_t seed) {
  constexpr double kShortest_m = 1.5;
  for (int trial = 0; trial < kTrials; ++trial) {
    Vector2d from_m;
    Vector2d to_m;
    if (!place(kPersonRoom_m, from_m) || !place(kPersonRoom_m, to_m)) return;
    if ((to_m - from_m).norm() < kShortest_m || !is_clear_way(from_m, to_m, kPersonRoom_m)) continue;
    Walker walker;
    walker.id = next_id("walker");
    walker.path = {.points_m = {from_m, to_m}, .loop = true};
    walker.avoids = true;
    const Body body = draw_body(static_cast<Person>(dice.whole(0, 2)), seed, walker.id);
    give_body(walker, body, static_cast<Clothing>(dice.whole(0, 2)), world.robot.laser_height_m);
    if (let_walk(walker)) return;
  }
}

}  // namespace scanbed::sim
