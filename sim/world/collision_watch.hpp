// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/world/solid_geometry.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

inline constexpr double kBetweenLooks_s = 0.05;  ///< nothing moves far in that time

/// Two things that the script takes into each other, and on through both.
struct Collision {
  double time_s = 0.0;  ///< when they were first seen to meet
  std::string first;    ///< who moves: "robot", or a walker's or a towed cylinder's id
  std::string second;   ///< id of a solid, a walker or a towed cylinder

  friend bool operator==(const Collision&, const Collision&) = default;
};

/// "at 1.25 s robot runs into column".
std::string to_string(const Collision& collision);

/// Looks for what the script of robot and walkers violates: the robot in a solid, in a leg or in a towed
/// cylinder; a leg in a solid at the laser's height, or in another walker's leg; a towed cylinder that is
/// pulled into a solid where it gets stuck. Legs that push a cylinder violate nothing.
///
/// Two things that part for less than a second meet once: a walker's legs swing in and out.
class CollisionWatch {
 public:
  /// @pre the world validates.
  explicit CollisionWatch(const World& world);

  /// Looks at a state; whoever calls does so every kBetweenLooks_s. Allocates only where something meets.
  /// @pre states come in the order of time.
  void look(const WorldState& state);

  /// All so far, in the order of time.
  const std::vector<Collision>& collisions() const { return collisions_; }

 private:
  struct Obstacle {
    int thing;
    ShapeOutline outline;
    bool stops_robot;
    bool stops_legs;
    double bottom_m, top_m;
  };
  /// Of two things, as numbers into names_.
  struct Meeting {
    int first;
    int second;
    double last_s;
  };

  void look_at_robot(const WorldState& state);
  void look_at_legs(const WorldState& state, std::size_t walker);
  void look_at_tow(const TowState& tow, const WalkerState& walker);
  int thing_of(const TowState& tow) const;
  void meet(int first, int second);

  double robot_radius_m_;
  std::vector<double> leg_radius_m_;  ///< of each walker
  std::vector<Tow> tows_;             ///< of each walker; any where it tows nothing
  std::vector<std::string> names_;    ///< the robot, walkers, what each walker tows, solids
  std::vector<Obstacle> obstacles_;
  std::vector<Meeting> meetings_;
  std::vector<Collision> collisions_;
  double time_s_ = 0.0;  ///< of the last look
};

}  // namespace scanbed::sim
