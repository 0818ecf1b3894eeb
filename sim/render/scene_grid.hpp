// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "sim/render/canvas.hpp"
#include "sim/render/scene_pen.hpp"
#include "sim/render/view_camera.hpp"

namespace scanbed::sim {

/// Lines along the world's axes on the floor, a metre apart, over the plan of `bounds`.
void draw_cartesian_grid(ScenePen& pen, const Eigen::AlignedBox3d& bounds, double scale);

/// Rings about the laser in the plane z = 0 of X_WS, and rays from it every 30 degrees, as far as `reach_m`;
/// each ring says its range where there is room for that.
/// @param X_WS  laser: x forward, z up; or what stands below it on the floor.
void draw_polar_grid(ScenePen& pen, const Eigen::Isometry3d& X_WS, double reach_m, double scale);
void label_polar_grid(Canvas& canvas, const ViewCamera& camera, const Eigen::Isometry3d& X_WS,
                      double reach_m);

/// Between the rings: 1, 2, 5, 10 ... m, so that there are at most eight.
double ring_step_m(double reach_m);

}  // namespace scanbed::sim
