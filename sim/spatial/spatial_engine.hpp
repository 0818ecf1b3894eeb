// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "sim/engine/engine.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// The spatial engine: a world in three dimensions, moved through time. The laser may be tilted; its plane
/// then also cuts the floor, seats, tops and bodies.
///
/// Robot and walkers follow the script exactly, as in the planar engine. Towed cylinders are MuJoCo's, in
/// fixed steps of 1/300 s from time 0, straight in between: where they are depends on the time alone.
///
/// With an upright laser in a world that stands still the scans of both engines are the same but for
/// rounding. Legs differ: here a shank leans, and is cut in an ellipse.
class SpatialEngine final : public Engine {
 public:
  /// @throws InputError where the world does not validate; SensorFault (kSimulator) where MuJoCo refuses it.
  explicit SpatialEngine(const World& world);
  ~SpatialEngine() override;

  void advance_to(double time_s) override;
  const WorldState& state() const override;
  DrivePlan& drive() override;
  const PlanarSlice& slice() const override;  ///< in the sensor frame: L is S
  Pose2 sensor_in_plane() const override;
  const std::vector<SliceObject>& objects() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
