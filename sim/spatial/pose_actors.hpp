// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// Where the parts of an actor go that is not in the world: below the floor, out of every picture.
inline constexpr double kAbsent_m = -1000.0;

/// Puts the mocap bodies of robot, walkers and tows where `state` says, and computes the poses that follow
/// (mj_kinematics, tendons). Actors that `state` does not name, or that are not present, go to z = kAbsent_m.
///
/// @pre `model` comes from mjcf_of(world), `data` from make_data(model). Checked; aborts.
void pose_actors(const World& world, const WorldState& state, const mjModel& model, mjData& data);

}  // namespace scanbed::sim
