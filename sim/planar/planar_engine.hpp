// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "sim/engine/engine.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// The planar engine: a world in the slice at laser height, moved through time.
///
/// Robot and walkers follow their scripts exactly; towed cylinders are Box2D's, in fixed steps of 1/300 s
/// from time 0, straight in between: where they are depends on the time alone, not on the times asked for
/// before.
class PlanarEngine final : public Engine {
 public:
  /// @throws InputError where the world does not validate or its laser is tilted.
  explicit PlanarEngine(const World& world);
  ~PlanarEngine() override;

  void advance_to(double time_s) override;
  const WorldState& state() const override;
  DrivePlan& drive() override;
  const PlanarSlice& slice() const override;  ///< in the world frame: L is W
  Pose2 sensor_in_plane() const override;
  const std::vector<SliceObject>& objects() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
