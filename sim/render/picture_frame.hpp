// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "core/detect/features.hpp"
#include "sim/render/canvas.hpp"
#include "sim/render/view_camera.hpp"

namespace scanbed::sim {

/// How much larger everything is than in a picture of 720 rows, for which it is laid out.
double picture_scale(const Canvas& canvas);

/// What the caption and the legend leave of a picture, in pixels.
Eigen::AlignedBox2d middle_of(const Canvas& canvas);

/// One line at the top of the picture; shortened with "..." where it is too long.
void draw_caption(Canvas& canvas, const std::string& caption);

/// The colours and what they mean, with the number of each, at the bottom of the picture.
/// @param note  at the right end, such as "floor tiles: 1 m"; where it has no room it is left out.
void draw_legend(Canvas& canvas, const Features& features, const std::string& note);

/// Coordinates along the left and the lower edge of a plan, faint lines across it, and a scale bar, all at
/// steps of 1, 2 or 5 times a power of ten metres that keep the numbers apart.
/// @pre `camera` looks straight down (plan_camera).
void draw_plan_scale(Canvas& canvas, const ViewCamera& camera);

/// The least of 1, 2, 5 times a power of ten metres that is at least `least_m`. @pre least_m > 0.
double round_step_m(double least_m);

}  // namespace scanbed::sim
