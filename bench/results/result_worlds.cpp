// SPDX-License-Identifier: MIT
#include "bench/results/result_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/results/world_dice.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::bench {
namespace {

using Eigen::Vector2d;
using sim::Solid;
using sim::World;

constexpr double kMinGap_m = 0.3;  // between things that stand free
constexpr double kRobotClearance_m = 0.4;

Vector2d polar(double bearing_rad, double length_m) {
  return length_m * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
}

/// Puts things into a hall, each clear of those before it.
class WorldBuilder {
 public:
  WorldBuilder(WorldSet set, std::uint64_t seed) : dice(seed, name_of(set)) {}

  std::string next_id(const char* what) { return what + std::to_string(num_things_++); }

  void add(const char* label, sim::SolidShape shape) {
    world.solids.push_back({.id = next_id(label), .label = label, .shape = std::move(shape)});
  }

  bool is_clear(const Vector2d& p_m, double radius_m) const {
    return std::all_of(world.solids.begin(), world.solids.end(),
                       [&](const Solid& solid) { return sim::clearance_m(solid.shape, p_m) >= radius_m; });
  }

  // A place inside the hall with so much room around it; what fits nowhere in 40 trials is left out.
  bool place(double radius_m, Vector2d& p_m) {
    for (int trial = 0; trial < 40; ++trial) {
      p_m = {dice.uniform(-half_m.x(), half_m.x()), dice.uniform(-half_m.y(), half_m.y())};
      const bool inside = (half_m - p_m.cwiseAbs()).minCoeff() > radius_m + kMinGap_m;
      const bool near_robot = (p_m - world.robot.X_WR.p_m).norm() < radius_m + kRobotClearance_m;
      if (inside && !near_robot && is_clear(p_m, radius_m + kMinGap_m)) return true;
    }
    return false;
  }

  void put_robot() {
    const Vector2d p_m(dice.uniform(-0.7, 0.7) * half_m.x(), dice.uniform(-0.7, 0.7) * half_m.y());
    // It looks along the farther half of the hall, give or take.
    const double ahead_rad = p_m.x() > 0.0 ? kPi : 0.0;
    world.robot.X_WR = {p_m, wrap_to_pi(ahead_rad + dice.uniform(-1.2, 1.2))};
  }

  void put_column(double min_radius_m, double max_radius_m) {
    // Small radii as often as large ones on a logarithmic scale.
    const double radius_m = min_radius_m * std::pow(max_radius_m / min_radius_m, dice.uniform(0.0, 1.0));
    Vector2d p_m;
    if (place(radius_m, p_m)) add("column", sim::Cylinder{p_m, radius_m});
  }

  void put_box(double min_size_m, double max_size_m, double max_aspect) {
    const double a_m = dice.uniform(min_size_m, max_size_m);
    const double b_m = std::min(a_m * dice.uniform(1.0, max_aspect), 2.0 * max_size_m);
    Vector2d p_m;
    if (!place(std::hypot(a_m, b_m) / 2, p_m)) return;
    add("box", sim::Box{{p_m, dice.uniform(-kPi, kPi)}, {a_m, b_m}});
  }

  void put_person() {
    Vector2d p_m;
    if (!place(0.4, p_m)) return;
    const Vector2d along_m = polar(dice.uniform(-kPi, kPi), 0.3);
    sim::Walker walker;
    walker.id = next_id("person");
    walker.path.points_m = {p_m, p_m + along_m};
    walker.leg_radius_m = dice.uniform(0.045, 0.075);
    world.walkers.push_back(walker);
  }

  // Walls around, with niches and projections of a few decimetres.
  void put_hall(double half_x_m, double half_y_m, double niche_chance) {
    half_m = {half_x_m, half_y_m};
    const Vector2d corners_m[] = {
        {-half_x_m, -half_y_m}, {half_x_m, -half_y_m}, {half_x_m, half_y_m}, {-half_x_m, half_y_m}};
    sim::WallChain chain{{}, true};
    for (int i = 0; i < 4; ++i) {
      const Vector2d a_m = corners_m[i];
      const Vector2d along = (corners_m[(i + 1) % 4] - a_m).normalized();
      const double length_m = (corners_m[(i + 1) % 4] - a_m).norm();
      const Vector2d outwards(along.y(), -along.x());
      chain.corners_m.push_back(a_m);
      double at_m = dice.uniform(0.5, 2.0);
      while (at_m + 2.0 < length_m) {
        if (dice.chance(niche_chance)) {
          const double width_m = dice.uniform(0.8, 1.2);
          const Vector2d step_m = dice.uniform(0.1, 0.35) * outwards;
          const Vector2d from_m = a_m + at_m * along;
          const Vector2d to_m = from_m + width_m * along;
          for (const Vector2d& c_m : {from_m, Vector2d(from_m + step_m), Vector2d(to_m + step_m), to_m}) {
            chain.corners_m.push_back(c_m);
          }
        }
        at_m += dice.uniform(1.8, 3.5);
      }
    }
    add("wall", chain);
  }

  WorldDice dice;
  World world;
  Vector2d half_m = Vector2d::Zero();

 private:
  int num_things_ = 0;
};

World room(std::uint64_t seed) {
  WorldBuilder b(WorldSet::kRooms, seed);
  b.put_hall(b.dice.uniform(2.5, 6.0), b.dice.uniform(2.0, 4.5), 0.35);
  b.put_robot();
  for (int i = b.dice.whole(2, 5); i > 0; --i) b.put_column(0.04, 1.0);
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_box(0.3, 1.0, 2.0);
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_person();
  return b.world;
}

World corridor(std::uint64_t seed) {
  WorldBuilder b(WorldSet::kCorridors, seed);
  b.put_hall(b.dice.uniform(4.0, 9.0), b.dice.uniform(0.8, 1.5), 0.6);
  b.put_robot();
  b.world.robot.X_WR.p_m.y() *= 0.5;
  b.world.robot.X_WR.theta_rad = (b.world.robot.X_WR.p_m.x() > 0.0 ? kPi : 0.0) + b.dice.uniform(-0.4, 0.4);
  b.world.robot.X_WR.theta_rad = wrap_to_pi(b.world.robot.X_WR.theta_rad);
  if (b.dice.chance(0.5)) b.put_column(0.06, 0.25);
  if (b.dice.chance(0.3)) b.put_person();
  return b.world;
}

// Something between the robot and a column that hides one side or the middle of it.
void put_occluder(WorldBuilder& b, const Vector2d& column_m, double radius_m) {
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
  WorldBuilder b(WorldSet::kCut, seed);
  b.put_hall(b.dice.uniform(4.0, 6.0), b.dice.uniform(3.0, 4.5), 0.3);
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
void put_v_corner(WorldBuilder& b) {
  const double leg_m = b.dice.uniform(0.15, 0.6);
  Vector2d p_m;
  if (!b.place(leg_m, p_m)) return;
  const double first_rad = b.dice.uniform(-kPi, kPi);
  const double between_rad = b.dice.uniform(radians(60.0), radians(150.0));
  b.add("corner", sim::WallChain{{p_m + polar(first_rad, leg_m), p_m,
                                  p_m + polar(first_rad + between_rad, leg_m * b.dice.uniform(0.6, 1.0))},
                                 false});
}

void put_chair(WorldBuilder& b) {
  Vector2d p_m;
  if (!b.place(0.4, p_m)) return;
  const double turn_rad = b.dice.uniform(-kPi, kPi);
  for (int i = 0; i < 4; ++i) {
    const Vector2d leg_m = p_m + polar(turn_rad + i * kPi / 2, 0.28);
    b.add("chair", sim::Box{{leg_m, turn_rad}, Vector2d::Constant(0.025)});
  }
}

World confusers(std::uint64_t seed) {
  WorldBuilder b(WorldSet::kConfusers, seed);
  b.put_hall(b.dice.uniform(3.0, 5.5), b.dice.uniform(2.5, 4.5), 0.5);
  b.put_robot();
  for (int i = b.dice.whole(1, 2); i > 0; --i) b.put_column(0.08, 0.5);
  for (int i = b.dice.whole(1, 3); i > 0; --i) b.put_box(0.16, 0.5, 1.0);
  for (int i = b.dice.whole(1, 2); i > 0; --i) put_v_corner(b);
  for (int i = b.dice.whole(0, 2); i > 0; --i) put_chair(b);
  for (int i = b.dice.whole(1, 2); i > 0; --i) b.put_box(0.1, 0.3, 6.0);
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
