// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// mjcf_of(world) with all that moves in its place at one moment, for programs that know nothing of scripts:
/// reset, the model shows that moment.
///
/// @throws SensorFault (kSimulator) where MuJoCo refuses the world.
std::string posed_mjcf(const World& world, const WorldState& state);

}  // namespace scanbed::sim
