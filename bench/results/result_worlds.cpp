// SPDX-License-Identifier: MIT
#include "bench/results/result_worlds.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"
#include "core/geometry/polar.hpp"
#include "sim/generate/world_builder.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::bench {
namespace {

using Eigen::Vector2d;
using sim::World;

using Builder = sim::WorldBuilder;

// A hall of random size. The draws stand in lines of their own: the order of arguments is the compiler's.
void put_hall(Builder& b, const sim::LengthRange& half_x, const sim::LengthRange& half_y,
              double niche_chance) {
  const double half_y_m = b.dice.uniform(half_y.least_m, half_y.greatest_m);
  const double half_x_m = b.dice.uniform(half_x.least_m, half_x.greatest_m);
  b.put_hall({half_x_m, half_y_m}, niche_chance);
}

World room(std::uint64_t seed) {
  Builder b(seed, name_of(WorldSet::kRooms));
  put_hall(b, {2.5, 6.0}, {2.0, 4.5}, 0.35);
  b.put_robot();
  for (int i = b.dice.whole(2, 5); i > 0; --i) b.put_cylinder("column", {0.04, 1.0});
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_box("box", {0.3, 1.0}, 2.0);
  b.rehearsal_s = 1.0;  // two may stand there: not in each other
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_standing_person();
  return b.world;
}

World corridor(std::uint64_t seed) {
  Builder b(seed, name_of(WorldSet::kCorridors));
  put_hall(b, {4.0, 9.0}, {0.8, 1.5}, 0.6);
  b.put_robot();
  b.world.robot.X_WR.p_m.y() *= 0.5;
  b.world.robot.X_WR.theta_rad = (b.world.robot.X_WR.p_m.x() > 0.0 ? kPi : 0.0) + b.dice.uniform(-0.4, 0.4);
  b.world.robot.X_WR.theta_rad = wrap_to_pi(b.world.robot.X_WR.theta_rad);
  if (b.dice.chance(0.5)) b.put_cylinder("column", {0.06, 0.25});
  if (b.dice.chance(0.3)) b.put_standing_person();
  return b.world;
}

// Something between the robot and a column that hides one side or the middle of it.
void put_occluder(Builder& b, const Vector2d& column_m, double radius_m) {
  const Vector2d robot_m = b.world.robot.X_WR.p_m;
  const Vector2d sight_m = column_m - robot_m;
  const double distance_m = sight_m.norm();
  const Vector2d ahead = sight_m / distance_m;
  const Vector2d across(-ahead.y(), ahead.x());
  const double share = b.dice.uniform(0.4, 0.85);  // of the way to the column
  if (distance_m * share < 0.6 || distance_m * (1.0 - share) < radius_m + 0.35) return;
  const double shadow_m = radius_m * share;  // half of the column's width there
  const bool splits = b.dice.chance(0.4) && shadow_m > 0.06;
  const double size_m = splits ? b.dice.uniform(0.1, 0.5) * shadow_m : b.dice.uniform(0.04, 0.25);
  const double side = b.dice.chance(0.5) ? 1.0 : -1.0;
  const double covered_m = b.dice.uniform(0.2, 1.1) * shadow_m;
  const double beside_m =
      splits ? b.dice.uniform(-0.4, 0.4) * shadow_m : side * (shadow_m - covered_m + size_m);
  const Vector2d at_m = robot_m + share * sight_m + beside_m * across;
  const bool is_in_another =
      std::any_of(b.world.solids.begin(), b.world.solids.end(),
                  [&](const sim::Solid& solid) { return sim::clearance_m(solid.shape, at_m) < 0.0; });
  if (is_in_another) return;
  switch (b.dice.whole(0, 2)) {
    case 0:
      return b.add("post", sim::Cylinder{at_m, size_m});
    case 1:
      return b.add("box", sim::Box{{at_m, b.dice.uniform(-kPi, kPi)}, Vector2d::Constant(1.5 * size_m)});
    default:
      return b.add("stub", sim::Box{{at_m, std::atan2(across.y(), across.x())}, {2.0 * size_m, 0.05}});
  }
}

World cut_columns(std::uint64_t seed) {
  Builder b(seed, name_of(WorldSet::kCut));
  put_hall(b, {4.0, 6.0}, {3.0, 4.5}, 0.3);
  b.put_robot();
  for (int i = b.dice.whole(3, 5); i > 0; --i) {
    const double radius_m = b.dice.uniform(0.12, 0.5);
    Vector2d p_m;
    if (!b.place(radius_m, p_m)) continue;
    b.add("column", sim::Cylinder{p_m, radius_m});
    put_occluder(b, p_m, radius_m);
  }
  return b.world;
}

// Two short walls that meet in an edge or a nook.
void put_v_corner(Builder& b) {
  const double leg_m = b.dice.uniform(0.15, 0.6);
  Vector2d p_m;
  if (!b.place(leg_m, p_m)) return;
  const double first_rad = b.dice.uniform(-kPi, kPi);
  const double between_rad = b.dice.uniform(radians(60.0), radians(150.0));
  b.add("corner", sim::WallChain{{p_m + polar(first_rad, leg_m), p_m,
                                  p_m + polar(first_rad + between_rad, leg_m * b.dice.uniform(0.6, 1.0))},
                                 false});
}

World confusers(std::uint64_t seed) {
  Builder b(seed, name_of(WorldSet::kConfusers));
  put_hall(b, {3.0, 5.5}, {2.5, 4.5}, 0.5);
  b.put_robot();
  for (int i = b.dice.whole(1, 2); i > 0; --i) b.put_cylinder("column", {0.08, 0.5});
  for (int i = b.dice.whole(1, 3); i > 0; --i) b.put_box("box", {0.16, 0.5}, 1.0);
  for (int i = b.dice.whole(1, 2); i > 0; --i) put_v_corner(b);
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_chair();
  for (int i = b.dice.whole(1, 2); i > 0; --i) b.put_box("box", {0.1, 0.3}, 6.0);
  return b.world;
}

}  // namespace

const char* name_of(WorldSet set) {
  switch (set) {
    case WorldSet::kRooms:
      return "rooms";
    case WorldSet::kCorridors:
      return "corridors";
    case WorldSet::kCut:
      return "columns cut by others";
    case WorldSet::kConfusers:
      return "confusers";
  }
  return "";
}

World result_world(WorldSet set, std::uint64_t seed) {
  switch (set) {
    case WorldSet::kRooms:
      return room(seed);
    case WorldSet::kCorridors:
      return corridor(seed);
    case WorldSet::kCut:
      return cut_columns(seed);
    case WorldSet::kConfusers:
      return confusers(seed);
  }
  return {};
}

}  // namespace scanbed::bench
