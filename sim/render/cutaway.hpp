// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Lowers the walls that stand between an outside camera and the middle of the scene to a kerb, as in a
/// doll's house, so that the camera sees in. Other shapes stay.
///
/// @param model   of mjcf_of(world); its geoms are changed.
/// @param camera  p_WC, @param middle  p_WM: a wall is lowered where its line parts them.
void cut_away_walls(const World& world, const Eigen::Vector2d& camera_m, const Eigen::Vector2d& middle_m,
                    mjModel& model);

}  // namespace scanbed::sim
