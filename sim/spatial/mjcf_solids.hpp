// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Walls are thin in the plan; in three dimensions they get this thickness, half on either side of their
/// line.
inline constexpr double kWallThickness_m = 0.06;

/// To the laser a wall stays as thin as in the plan, for else the engines would not agree on ranges: it meets
/// a sheet of this thickness (MuJoCo knows no boxes without any), which pictures do not show.
inline constexpr double kSheetThickness_m = 1e-8;

/// Adds the geoms of one solid to `worldbody`, and the mesh of a polygon to `asset`. Where walls of a chain
/// meet they are longer by half their thickness, so that the corner is closed.
void add_solid(const Solid& solid, pugi::xml_node worldbody, pugi::xml_node asset);

}  // namespace scanbed::sim
