// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace scanbed::sim {

/// Where a point of the world falls in a picture.
struct Projection {
  Eigen::Vector2d at_px = Eigen::Vector2d::Zero();  ///< right and down from the picture's upper left corner
  double depth_m = 0.0;                             ///< along the camera's axis
};

/// A pinhole camera. Frame C as in OpenGL: x right, y up, z backwards.
struct ViewCamera {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  double half_height_ratio = 0.5;  ///< tangent of half the vertical field of view
  double near_m = 0.1;             ///< nothing nearer is drawn
  double far_m = 100.0;            ///< nothing farther is drawn
  int width_px = 640;
  int height_px = 480;

  /// Empty for points nearer than near_m.
  std::optional<Projection> project(const Eigen::Vector3d& p_WQ) const;

  /// Pixels that one metre across the axis covers at this depth.
  double px_per_m(double depth_m) const { return 0.5 * height_px / (half_height_ratio * depth_m); }
};

/// Parts of the picture, of its height, that stay free of the scene: caption above, legend below, axes.
struct FrameMargins {
  double top_ratio = 0.075;
  double bottom_ratio = 0.10;
  double side_ratio = 0.06;
};

struct PictureSize {
  int width_px = 640;
  int height_px = 480;
};

/// From straight above, y up in the picture, so far away that heights hardly shift anything (under 0.5 % of
/// their distance to the middle a metre); `bounds` fills the frame inside the margins.
ViewCamera plan_camera(const Eigen::AlignedBox3d& bounds, PictureSize size, const FrameMargins& margins);

/// Obliquely down along `heading_rad` in the world; all of `bounds` is inside the margins.
ViewCamera oblique_camera(const Eigen::AlignedBox3d& bounds, double heading_rad, PictureSize size,
                          const FrameMargins& margins);

struct DepthRange {
  double near_m = 0.25;
  double far_m = 100.0;
};

/// From the laser's origin along its x axis. @param X_WS  x forward, z up.
ViewCamera laser_camera(const Eigen::Isometry3d& X_WS, const DepthRange& depth, PictureSize size);

}  // namespace scanbed::sim
