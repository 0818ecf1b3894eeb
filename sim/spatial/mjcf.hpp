// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// The world as MJCF, MuJoCo's model format: floor, solids, robot, walkers, towed cylinders and ropes, well
/// lit. What follows the script is a mocap body at the origin (see pose_actors); towed cylinders are free
/// bodies on limited tendons. Metres, radians, world frame W with z up
/// and the floor at z = 0. Any text is fine as an id; equal ids make a model that load_model refuses.
std::string mjcf_of(const World& world);

}  // namespace scanbed::sim
