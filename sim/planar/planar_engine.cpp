// SPDX-License-Identifier: MIT
#include "sim/planar/planar_engine.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "sim/engine/physics_step.hpp"
#include "sim/planar/floor_physics.hpp"
#include "sim/world/world_script.hpp"

namespace scanbed::sim {
namespace {

const World& validated(const World& world) {
  world.validate();
  for (const double tilt_rad : {world.robot.laser_pitch_rad, world.robot.laser_roll_rad}) {
    require(tilt_rad == 0.0, "sensor: pitch_deg and roll_deg", degrees(tilt_rad),
            "0 in the planar engine; the spatial one (--backend spatial) takes any");
  }
  return world;
}

}  // namespace

struct PlanarEngine::Impl {
  explicit Impl(const World& world);
  void step_physics();
  void place_tows();

  Pose2 X_RS;
  WorldScript script;
  SliceObjects slice_objects;
  std::optional<FloorPhysics> physics;  ///< only where something is towed
  std::int64_t num_substeps = 0;
  WorldState before;  ///< at the last substep but one
  WorldState behind;  ///< at the last substep
  WorldState state;
  PlanarSlice slice;
};

PlanarEngine::Impl::Impl(const World& world) : X_RS(world.robot.X_RS), script(world), slice_objects(world) {
  script.follow(0.0, state);
  if (script.has_tows()) {
    physics.emplace(world, state);
    physics->step_to(state);
  }
  before = state;
  behind = state;
  slice_objects.slice_at(state, slice);
}

void PlanarEngine::Impl::step_physics() {
  ++num_substeps;
  std::swap(before, behind);
  script.follow(static_cast<double>(num_substeps) / kPhysicsSteps_per_s, behind);
  physics->step_to(behind);
}

void PlanarEngine::Impl::place_tows() {
  const double span_s = behind.time_s - before.time_s;
  const double ratio = span_s > 0.0 ? (state.time_s - before.time_s) / span_s : 1.0;
  state.tows.resize(behind.tows.size());
  for (std::size_t i = 0; i < behind.tows.size(); ++i) {
    const TowState& to = behind.tows[i];
    const Eigen::Vector2d from_m = before.tows[i].present ? before.tows[i].center_m : to.center_m;
    state.tows[i] = {to.walker, to.present && state.walkers[to.walker].present,
                     from_m + ratio * (to.center_m - from_m)};
  }
}

PlanarEngine::PlanarEngine(const World& world) : impl_(std::make_unique<Impl>(validated(world))) {}

PlanarEngine::~PlanarEngine() = default;

void PlanarEngine::advance_to(double time_s) {
  SCANBED_ENSURE(std::isfinite(time_s) && time_s >= impl_->state.time_s);
  impl_->script.follow(time_s, impl_->state);
  if (impl_->physics) {
    while (impl_->behind.time_s < time_s) impl_->step_physics();
    impl_->place_tows();
  }
  impl_->slice_objects.slice_at(impl_->state, impl_->slice);
}

const WorldState& PlanarEngine::state() const {
  return impl_->state;
}

DrivePlan& PlanarEngine::drive() {
  return impl_->script.drive();
}

const PlanarSlice& PlanarEngine::slice() const {
  return impl_->slice;
}

Pose2 PlanarEngine::sensor_in_plane() const {
  return impl_->state.X_WR * impl_->X_RS;
}

const std::vector<SliceObject>& PlanarEngine::objects() const {
  return impl_->slice_objects.objects();
}

}  // namespace scanbed::sim
