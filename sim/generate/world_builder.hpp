// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/generate/hall_outline.hpp"
#include "sim/generate/world_dice.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Builds a random world: first the walls, then the robot, then one thing after the other, each clear of
/// those before it and of the robot's way; last the people, with whom a rehearsal must show no collision.
/// What fits nowhere in 40 trials is left out.
class WorldBuilder {
 public:
  /// @param purpose  the same seed gives other worlds for another purpose.
  WorldBuilder(std::uint64_t seed, std::string_view purpose) : dice(seed, purpose) {}

  WorldDice dice;
  World world;
  double rehearsal_s = 0.0;                          ///< of everybody who is put; 0: none
  Eigen::Vector2d half_m = Eigen::Vector2d::Zero();  ///< things stand in |x| <= half.x, |y| <= half.y

  /// "column4": an id that no other thing has.
  std::string next_id(const char* what) { return what + std::to_string(num_things_++); }

  void add(const char* label, SolidShape shape);

  /// Walls around, with niches and projections of a few decimetres.
  void put_hall(const Eigen::Vector2d& half_size_m, double niche_chance);

  /// A wall across the hall with a doorway in it, away from the robot.
  void put_partition();

  /// Somewhere in the middle; it looks along the farther half of the hall, give or take.
  void put_robot();

  /// A way straight ahead that the robot will drive.
  void let_robot_go(double distance_m);

  /// Small radii as often as large ones on a logarithmic scale.
  void put_cylinder(const char* label, const LengthRange& radius);
  void put_box(const char* label, const LengthRange& size, double max_aspect);
  void put_chair();
  void put_bench();
  void put_standing_person();

  /// To and fro on a straight way.
  void put_walker(std::uint64_t seed);

  /// A place inside the hall with so much room around it.
  bool place(double radius_m, Eigen::Vector2d& p_m);

 private:
  bool is_clear(const Eigen::Vector2d& p_m, double radius_m) const;
  bool is_clear_way(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double radius_m) const;
  double distance_to_robot_m(const Eigen::Vector2d& p_m) const;
  bool let_walk(const Walker& walker);  // false where the rehearsal shows a collision; then nobody is added

  int num_things_ = 0;
  double way_m_ = 0.0;  // that the robot will drive, straight ahead
};

}  // namespace scanbed::sim
