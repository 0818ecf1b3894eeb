// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "sim/render/scene_pen.hpp"

namespace scanbed::sim {

/// How a scan and its features are laid over a picture.
struct OverlayStyle {
  bool beams = true;   ///< a thin line from the laser to each echo
  double scale = 1.0;  ///< of all widths: 1 suits a picture of 720 rows
  double ribbon_m =
      0.0;  ///< features also reach this far above and below the laser's plane, for views along it
};

/// Draws echoes as dots, and the beams to them. @param X_WS  laser: x forward, z up.
void draw_scan(ScenePen& pen, const Eigen::Isometry3d& X_WS, const LaserScan& scan,
               const OverlayStyle& style);

/// Draws lines red, circles green as rings with their centre, legs purple as rings about their middle point,
/// all at the laser's height. Features that are not finite are left out.
void draw_features(ScenePen& pen, const Eigen::Isometry3d& X_WS, const Features& features,
                   const OverlayStyle& style);

}  // namespace scanbed::sim
