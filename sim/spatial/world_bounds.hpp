// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Smallest upright box, world frame, metres, that holds the solids, the walkers' paths with the walkers on
/// them and the robot at its start. Never empty: at least 2 m wide and deep, 1 m high,
/// and it stands on the floor.
Eigen::AlignedBox3d world_bounds(const World& world);

}  // namespace scanbed::sim
