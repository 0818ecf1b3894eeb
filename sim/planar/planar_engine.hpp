// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "sim/planar/planar_slice.hpp"
#include "sim/planar/slice_objects.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// The planar engine: a world in the slice at laser height, moved through time.
///
/// Robot and walkers follow their scripts exactly; towed cylinders are Box2D's, in fixed steps of 1/300 s
/// from time 0, straight in between: where they are depends on the time alone, not on the times asked for
/// before.
class PlanarEngine {
 public:
  /// @throws InputError where the world does not validate.
  explicit PlanarEngine(const World& world);
  ~PlanarEngine();
  PlanarEngine(const PlanarEngine&) = delete;
  PlanarEngine& operator=(const PlanarEngine&) = delete;

  /// @pre time_s is finite and not before the time of the last call (nor 0).
  void advance_to(double time_s);

  const WorldState& state() const;
  const PlanarSlice& slice() const;  ///< at state().time_s
  const std::vector<SliceObject>& objects() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
