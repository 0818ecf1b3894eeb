// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/pose2.hpp"
#include "sim/planar/planar_slice.hpp"
#include "sim/planar/slice_objects.hpp"
#include "sim/world/drive_plan.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// A world that moves through time: all that the simulated laser, pictures and truth know of a physics
/// engine.
///
/// An engine does not cast rays. It says what the laser's plane cuts out of its world, and one ray caster
/// casts the slices of every engine.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  /// @pre time_s is finite and not before the time of the last call (nor 0).
  /// @throws SensorFault (kSimulator) where the physics fails.
  virtual void advance_to(double time_s) = 0;

  virtual const WorldState& state() const = 0;

  /// The robot's plan, to command it where it follows legs.
  virtual DrivePlan& drive() = 0;

  /// What the laser's plane meets at state().time_s, in a frame L of that plane: the engine chooses where L
  /// is, and it may be elsewhere after the next advance_to().
  virtual const PlanarSlice& slice() const = 0;

  /// The sensor in that plane at state().time_s: X_LS.
  virtual Pose2 sensor_in_plane() const = 0;

  /// What a slice can hold; SliceSegment::object and its like are indices into this.
  virtual const std::vector<SliceObject>& objects() const = 0;
};

}  // namespace scanbed::sim
