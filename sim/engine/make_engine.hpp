// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>

#include "sim/engine/engine.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Which physics engine moves a world: Box2D in the laser's plane, or MuJoCo in space.
enum class Backend { kPlanar, kSpatial };

/// "planar" and "spatial", in the order of Backend.
std::span<const std::string> backend_names();
const std::string& to_string(Backend backend);

/// @throws InputError where the world does not validate, or is not one for this engine;
///         SensorFault (kSimulator) where the engine refuses it.
std::unique_ptr<Engine> make_engine(const World& world, Backend backend);

}  // namespace scanbed::sim
