// SPDX-License-Identifier: MIT
#include "sim/generate/random_world.hpp"

#include <array>
#include <optional>
#include <vector>

#include "sim/generate/world_builder.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

const std::array<std::string, 2> kNames = {"rooms", "corridors"};

World random_rooms(std::uint64_t seed, double laser_height_m, double rehearsal_s) {
  WorldBuilder b(seed, "random_rooms");
  b.world.robot.laser_height_m = laser_height_m;
  b.rehearsal_s = rehearsal_s;
  b.put_hall({b.dice.uniform(3.0, 6.0), b.dice.uniform(2.5, 4.5)}, 0.35);
  b.put_robot();
  if (b.dice.chance(0.5)) b.put_partition();
  for (int i = b.dice.whole(1, 4); i > 0; --i) b.put_cylinder("column", {0.06, 0.5});
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_box("post", {0.1, 0.4}, 1.0);
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_box("box", {0.3, 0.8}, 2.0);
  for (int i = b.dice.whole(0, 3); i > 0; --i) b.put_chair();
  for (int i = b.dice.whole(0, 1); i > 0; --i) b.put_bench();
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_cylinder("trash_can", {0.13, 0.19});
  for (int i = b.dice.whole(0, 1); i > 0; --i) b.put_standing_person();
  for (int i = b.dice.whole(0, 3); i > 0; --i) b.put_walker(seed);
  return b.world;
}

/// A corridor that crosses another one; along the side of that one, from its beginning.
struct Crossing {
  double at_m = 0.0;    // of its middle
  double half_m = 0.0;  // of its width
  double arm_m = 0.0;   // how far it goes to either side
};

// One side of a corridor: x along it, y outwards. Recessed doors, and the mouth of a crossing corridor.
std::vector<Vector2d> draw_side(WorldDice& dice, double length_m, const std::optional<Crossing>& crossing) {
  std::vector<Vector2d> points_m;
  const auto recess = [&](double from_m, double to_m, double depth_m) {
    for (const Vector2d& p_m :
         {Vector2d(from_m, 0.0), Vector2d(from_m, depth_m), Vector2d(to_m, depth_m), Vector2d(to_m, 0.0)}) {
      points_m.push_back(p_m);
    }
  };
  bool is_crossed = !crossing;
  double at_m = dice.uniform(0.4, 2.0);
  while (at_m + 1.5 < length_m) {
    const double behind_m = at_m + dice.uniform(0.8, 1.2);
    const bool is_door = dice.chance(0.7);
    const double depth_m = dice.uniform(0.08, 0.3);
    if (!is_crossed && behind_m + 0.4 > crossing->at_m - crossing->half_m) {
      recess(crossing->at_m - crossing->half_m, crossing->at_m + crossing->half_m, crossing->arm_m);
      is_crossed = true;
      at_m = crossing->at_m + crossing->half_m + dice.uniform(0.4, 1.5);
      continue;
    }
    if (is_door) recess(at_m, behind_m, depth_m);
    at_m = behind_m + dice.uniform(0.5, 2.5);
  }
  return points_m;
}

// The corridor lies along x, its middle at the origin.
void put_corridor(WorldBuilder& b) {
  b.half_m = {b.dice.uniform(5.0, 9.0), b.dice.uniform(0.9, 1.5)};
  const double length_m = 2.0 * b.half_m.x();
  std::optional<Crossing> south;
  std::optional<Crossing> north;
  if (b.dice.chance(0.5)) {
    south = {.at_m = length_m * b.dice.uniform(0.4, 0.6),
             .half_m = b.dice.uniform(0.8, 1.3),
             .arm_m = b.dice.uniform(2.0, 5.0)};
    north = {.at_m = length_m - south->at_m, .half_m = south->half_m, .arm_m = b.dice.uniform(2.0, 5.0)};
  }
  WallChain chain{{-b.half_m}, true};
  for (const Vector2d& p_m : draw_side(b.dice, length_m, south)) {
    chain.corners_m.push_back(-b.half_m + Vector2d(p_m.x(), -p_m.y()));
  }
  chain.corners_m.emplace_back(b.half_m.x(), -b.half_m.y());
  chain.corners_m.push_back(b.half_m);
  for (const Vector2d& p_m : draw_side(b.dice, length_m, north)) {
    chain.corners_m.push_back(b.half_m + Vector2d(-p_m.x(), p_m.y()));
  }
  chain.corners_m.emplace_back(-b.half_m.x(), b.half_m.y());
  b.add("wall", chain);
}

World random_corridors(std::uint64_t seed, double laser_height_m, double rehearsal_s) {
  WorldBuilder b(seed, "random_corridors");
  b.world.robot.laser_height_m = laser_height_m;
  b.rehearsal_s = rehearsal_s;
  put_corridor(b);
  const double start_m = b.dice.uniform(0.6, 1.5);
  b.world.robot.X_WR = {{-b.half_m.x() + start_m, b.dice.uniform(-0.3, 0.3)}, 0.0};
  b.world.robot.speed_m_per_s = 0.4;
  b.let_robot_go(b.dice.uniform(4.0, 2.0 * b.half_m.x() - start_m - 1.0));
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_cylinder("column", {0.06, 0.2});
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_cylinder("trash_can", {0.13, 0.19});
  for (int i = b.dice.whole(0, 1); i > 0; --i) b.put_box("post", {0.1, 0.2}, 1.0);
  for (int i = b.dice.whole(0, 1); i > 0; --i) b.put_chair();
  for (int i = b.dice.whole(0, 2); i > 0; --i) b.put_walker(seed);
  return b.world;
}

}  // namespace

std::span<const std::string> world_kind_names() {
  return kNames;
}

World random_world(WorldKind kind, std::uint64_t seed, double laser_height_m, double rehearsal_s) {
  return kind == WorldKind::kRooms ? random_rooms(seed, laser_height_m, rehearsal_s)
                                   : random_corridors(seed, laser_height_m, rehearsal_s);
}

}  // namespace scanbed::sim
