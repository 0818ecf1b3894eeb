// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/scan/range_sensor.hpp"
#include "sim/engine/make_engine.hpp"
#include "sim/sensor/lms_options.hpp"
#include "sim/world/collision_watch.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

struct SimulationOptions {
  LmsOptions lms;
  double duration_s = 10.0;  ///< the stream ends after the last scan that starts before it
  std::uint64_t seed = 1;
  Backend backend = Backend::kPlanar;
  DetectorOptions detector;  ///< finds the legs that a robot follows
};

/// A simulated LMS 200 in a world of either engine: world -> ideal returns -> LMS model -> 13-bit words ->
/// LaserScan.
///
/// A robot that follows legs acts on each scan from the time of the next one on: so long a scan is under way
/// to it.
class SimulatedLms final : public RangeSensor {
 public:
  /// @throws InputError where world or options do not validate.
  SimulatedLms(World world, const SimulationOptions& options);
  ~SimulatedLms() override;

  const ScanGeometry& geometry() const override;
  bool next(LaserScan& scan, Seconds timeout) override;
  const Truth* truth() const override;

  const World& world() const;

  /// The moving things at the time of the scan that next() gave last (before the first: at time 0).
  const WorldState& state() const;

  /// What the script has driven into each other so far.
  const std::vector<Collision>& collisions() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
