// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "core/scan/truth.hpp"
#include "sim/render/canvas.hpp"
#include "sim/render/scene_pen.hpp"
#include "sim/render/view_camera.hpp"

namespace scanbed::sim {

/// Draws where the objects truly are that the scan met: walls as lines, round things as rings, in dark blue,
/// thinner than features. @param X_WS  laser: x forward, z up.
void draw_truth(ScenePen& pen, const Eigen::Isometry3d& X_WS, const Truth& truth, double scale);

/// Writes the ids of those objects beside them, clear of each other where there is room; what lies outside
/// the picture's middle (see middle_of()) is left out.
void draw_labels(Canvas& canvas, const ViewCamera& camera, const Eigen::Isometry3d& X_WS, const Truth& truth);

}  // namespace scanbed::sim
