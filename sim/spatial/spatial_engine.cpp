// SPDX-License-Identifier: MIT
#include "sim/spatial/spatial_engine.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/errors/ensure.hpp"
#include "sim/spatial/laser_mount.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "sim/spatial/spatial_slicer.hpp"
#include "sim/spatial/tow_physics.hpp"
#include "sim/world/world_script.hpp"

namespace scanbed::sim {
namespace {

const World& validated(const World& world) {
  world.validate();
  return world;
}

}  // namespace

struct SpatialEngine::Impl {
  explicit Impl(const World& description);
  void step_physics();
  void place_tows();
  void look();

  World world;
  WorldScript script;
  ModelPtr model;
  DataPtr view;  ///< the moment that is looked at; physics has its own data
  ActorPoser poser;
  SpatialSlicer slicer;
  std::optional<TowPhysics> physics;  ///< only where something is towed
  std::int64_t num_steps = 0;
  WorldState script_state;              ///< at the last step
  std::vector<Eigen::Vector3d> before;  ///< p_WB of the towed cylinders at the last step but one
  std::vector<Eigen::Vector3d> behind;  ///< at the last step
  std::vector<Eigen::Vector3d> tows;    ///< at the state's time
  WorldState state;
  PlanarSlice slice;
};

SpatialEngine::Impl::Impl(const World& description)
    : world(validated(description)),
      script(world),
      model(load_model(mjcf_of(world))),
      view(make_data(*model)),
      poser(world, *model),
      slicer(world, *model) {
  script.follow(0.0, state);
  if (script.has_tows()) {
    physics.emplace(world, *model, state);
    script_state = state;
    before = physics->places();
    behind = physics->places();
    place_tows();
  }
  look();
}

void SpatialEngine::Impl::step_physics() {
  ++num_steps;
  script.follow(static_cast<double>(num_steps) * TowPhysics::kStep_s, script_state);
  physics->step_to(script_state);
  std::swap(before, behind);
  behind = physics->places();
}

void SpatialEngine::Impl::place_tows() {
  const double behind_s = static_cast<double>(num_steps) * TowPhysics::kStep_s;
  const double back = num_steps == 0 ? 0.0 : (behind_s - state.time_s) / TowPhysics::kStep_s;
  tows = behind;
  state.tows.resize(behind.size());
  for (std::size_t i = 0; i < behind.size(); ++i) {
    const int walker = physics->walker(static_cast<int>(i));
    const Eigen::Vector3d way_m = behind[i] - before[i];
    // A cylinder that has just appeared did not fly in from where the absent are kept.
    if (way_m.squaredNorm() <= 1.0) tows[i] -= back * way_m;
    state.tows[i] = {walker, state.walkers[walker].present, tows[i].head<2>()};
  }
}

void SpatialEngine::Impl::look() {
  poser.put(state, *view);
  for (std::size_t i = 0; i < state.tows.size(); ++i) {
    if (state.tows[i].present) poser.put_tow(static_cast<int>(i), tows[i], *view);
  }
  mj_kinematics(model.get(), view.get());
  slicer.slice(*view, laser_plane(world.robot, state.X_WR), state, slice);
}

SpatialEngine::SpatialEngine(const World& world) : impl_(std::make_unique<Impl>(world)) {}

SpatialEngine::~SpatialEngine() = default;

void SpatialEngine::advance_to(double time_s) {
  Impl& self = *impl_;
  SCANBED_ENSURE(std::isfinite(time_s) && time_s >= self.state.time_s);
  self.script.follow(time_s, self.state);
  if (self.physics) {
    while (static_cast<double>(self.num_steps) * TowPhysics::kStep_s < time_s) self.step_physics();
    self.place_tows();
  }
  self.look();
}

const WorldState& SpatialEngine::state() const {
  return impl_->state;
}

DrivePlan& SpatialEngine::drive() {
  return impl_->script.drive();
}

const PlanarSlice& SpatialEngine::slice() const {
  return impl_->slice;
}

Pose2 SpatialEngine::sensor_in_plane() const {
  return {};
}

const std::vector<SliceObject>& SpatialEngine::objects() const {
  return impl_->slicer.objects();
}

}  // namespace scanbed::sim
