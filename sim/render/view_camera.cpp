// SPDX-License-Identifier: MIT
#include "sim/render/view_camera.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"

namespace scanbed::sim {
namespace {

// Camera frame that looks along `forward`, with `up` upwards in the picture.
Eigen::Matrix3d looking(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  Eigen::Matrix3d R_WC;
  R_WC.col(2) = -forward.normalized();
  R_WC.col(0) = up.cross(R_WC.col(2)).normalized();
  R_WC.col(1) = R_WC.col(2).cross(R_WC.col(0));
  return R_WC;
}

// What the margins leave of the frame, as tangents from the axis.
struct FreeFrame {
  double left, right, bottom, top;
};

FreeFrame free_frame(const ViewCamera& camera, const FrameMargins& margins) {
  const double t = camera.half_height_ratio;
  const double aspect = static_cast<double>(camera.width_px) / camera.height_px;
  const double side = std::max(0.2 * aspect * t, (aspect - 2.0 * margins.side_ratio) * t);
  return {-side, side, -t * (1.0 - 2.0 * margins.bottom_ratio), t * (1.0 - 2.0 * margins.top_ratio)};
}

// Moves the camera, without turning it, to where the box just fits into the free frame: across the axis each
// pair of opposite sides of the frustum touches the box; the pair that needs more room sets the distance.
void fit(ViewCamera& camera, const Eigen::AlignedBox3d& bounds, const FreeFrame& frame) {
  const Eigen::Matrix3d R_CW = camera.X_WC.linear().transpose();
  // Over the corners: greatest and least of x + tangent * z, where z points back at the camera.
  Eigen::Array4d reach = Eigen::Array4d::Constant(-1e300);  // right, left, top, bottom
  double z_near_m = -1e300;
  double z_far_m = 1e300;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d q = R_CW * bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    const Eigen::Array4d corner(q.x() + frame.right * q.z(), -q.x() - frame.left * q.z(),
                                q.y() + frame.top * q.z(), -q.y() - frame.bottom * q.z());
    reach = reach.max(corner);
    z_near_m = std::max(z_near_m, q.z());
    z_far_m = std::min(z_far_m, q.z());
  }
  // The camera c sees all corners if  reach_right <= c.x + right * c.z  and  reach_left <= -c.x - left * c.z,
  // likewise up and down.
  const double z_across = (reach[0] + reach[1]) / (frame.right - frame.left);
  const double z_upward = (reach[2] + reach[3]) / (frame.top - frame.bottom);
  const double z_m = std::max({z_across, z_upward, z_near_m + 0.1});
  const double x_m = 0.5 * ((reach[0] - frame.right * z_m) - (reach[1] + frame.left * z_m));
  const double y_m = 0.5 * ((reach[2] - frame.top * z_m) - (reach[3] + frame.bottom * z_m));
  camera.X_WC.translation() = camera.X_WC.linear() * Eigen::Vector3d(x_m, y_m, z_m);
  camera.near_m = std::max(0.3 * (z_m - z_near_m), 0.02);
  camera.far_m = 3.0 * (z_m - z_far_m) + 10.0;
}

}  // namespace

std::optional<Projection> ViewCamera::project(const Eigen::Vector3d& p_WQ) const {
  const Eigen::Vector3d p_CQ = X_WC.linear().transpose() * (p_WQ - X_WC.translation());
  const double depth_m = -p_CQ.z();
  if (depth_m < near_m) return std::nullopt;
  const double scale = px_per_m(depth_m);
  return Projection{{0.5 * width_px + scale * p_CQ.x(), 0.5 * height_px - scale * p_CQ.y()}, depth_m};
}

ViewCamera plan_camera(const Eigen::AlignedBox3d& bounds, PictureSize size, const FrameMargins& margins) {
  constexpr double kHalfFov_rad = 0.0025;
  ViewCamera camera;
  camera.width_px = size.width_px;
  camera.height_px = size.height_px;
  camera.half_height_ratio = std::tan(kHalfFov_rad);
  camera.X_WC.linear() = looking(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
  fit(camera, bounds, free_frame(camera, margins));
  // The usual planes of so far a camera would waste the depth buffer on empty air; these are symmetric about
  // the scene and leave room for what casts shadows into it.
  const double reach_m = bounds.diagonal().norm();
  camera.near_m = camera.X_WC.translation().z() - reach_m;
  camera.far_m = camera.X_WC.translation().z() + reach_m;
  return camera;
}

ViewCamera oblique_camera(const Eigen::AlignedBox3d& bounds, double heading_rad, PictureSize size,
                          const FrameMargins& margins) {
  constexpr double kDown_rad = radians(48.0);
  ViewCamera camera;
  camera.width_px = size.width_px;
  camera.height_px = size.height_px;
  camera.half_height_ratio = std::tan(radians(17.0));
  const Eigen::Vector3d forward(std::cos(kDown_rad) * std::cos(heading_rad),
                                std::cos(kDown_rad) * std::sin(heading_rad), -std::sin(kDown_rad));
  camera.X_WC.linear() = looking(forward, Eigen::Vector3d::UnitZ());
  fit(camera, bounds, free_frame(camera, margins));
  return camera;
}

ViewCamera laser_camera(const Eigen::Isometry3d& X_WS, const DepthRange& depth, PictureSize size) {
  ViewCamera camera;
  camera.width_px = size.width_px;
  camera.height_px = size.height_px;
  camera.half_height_ratio = std::tan(radians(30.0));
  camera.X_WC.linear() = looking(X_WS.linear().col(0), X_WS.linear().col(2));
  camera.X_WC.translation() = X_WS.translation();
  camera.near_m = depth.near_m;
  camera.far_m = depth.far_m;
  return camera;
}

}  // namespace scanbed::sim
