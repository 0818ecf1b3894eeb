// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Walls are thin in the plan; in three dimensions they get this thickness, half on either side of their
/// line.
inline constexpr double kWallThickness_m = 0.06;

/// Adds the geoms of one solid to `worldbody`, and the mesh of a polygon to `asset`. Where walls of a chain
/// meet they are longer by half their thickness, so that the corner is closed.
void add_solid(const Solid& solid, pugi::xml_node worldbody, pugi::xml_node asset);

}  // namespace scanbed::sim
