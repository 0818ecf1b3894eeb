// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// Towed cylinders on the floor, seen from above: Box2D in single precision.
///
/// Each cylinder is a dynamic disc on a rope (slack below its length) from its walker's pelvis to the point
/// of its surface nearest to it, held back by Coulomb friction over its whole base. Solids at the cylinders'
/// heights stop it; legs and the robot are moved along the script and push it, whatever the force.
class FloorPhysics {
 public:
  /// Puts the cylinders of the walkers present in `start` a rope's length behind them.
  /// @pre the world validates.
  FloorPhysics(const World& world, const WorldState& start);
  ~FloorPhysics();
  FloorPhysics(const FloorPhysics&) = delete;
  FloorPhysics& operator=(const FloorPhysics&) = delete;

  /// One time step, to `next.time_s`; scripted things reach where `next` has them. Writes the cylinders into
  /// next.tows.
  void step_to(WorldState& next);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
