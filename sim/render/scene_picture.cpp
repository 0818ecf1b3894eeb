// SPDX-License-Identifier: MIT
#include "sim/render/scene_picture.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "core/errors/input_error.hpp"
#include "sim/render/canvas.hpp"
#include "sim/render/cutaway.hpp"
#include "sim/render/picture_frame.hpp"
#include "sim/render/scan_overlay.hpp"
#include "sim/render/scene_grid.hpp"
#include "sim/render/scene_pen.hpp"
#include "sim/render/scene_renderer.hpp"
#include "sim/render/truth_overlay.hpp"
#include "sim/render/view_camera.hpp"
#include "sim/spatial/laser_mount.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "sim/spatial/world_bounds.hpp"

namespace scanbed::sim {
namespace {

const PictureOptions& validated(const PictureOptions& options) {
  options.validate();
  return options;
}

// Where the camera looks is turned a little from where the robot looks, so that its beams do not hide behind
// it.
constexpr double kAside_rad = radians(-18.0);

}  // namespace

void PictureOptions::validate() const {
  const std::string allowed = "[" + std::to_string(kLeast_px) + ", " + std::to_string(kMost_px) + "]";
  require(width_px >= kLeast_px && width_px <= kMost_px, "picture.width_px", width_px, allowed);
  require(height_px >= kLeast_px && height_px <= kMost_px, "picture.height_px", height_px, allowed);
}

struct ScenePainter::Impl {
  Impl(World scene_world, const PictureOptions& picture_options)
      : world(std::move(scene_world)),
        options(validated(picture_options)),
        bounds(world_bounds(world)),
        model(load_model(mjcf_of(world))),
        data(make_data(*model)),
        renderer(*model, {options.width_px, options.height_px}) {
    renderer.cast_shadows(options.view != View::kTop);
    if (options.view == View::kCamera) {
      const Eigen::Vector2d middle_m = bounds.center().head<2>();
      cut_away_walls(world, fixed_camera().X_WC.translation().head<2>(), middle_m, *model);
    }
  }

  ViewCamera fixed_camera() const {
    const PictureSize size{options.width_px, options.height_px};
    if (options.view == View::kTop) return plan_camera(bounds, size, {});
    return oblique_camera(bounds, world.robot.X_WR.theta_rad + kAside_rad, size, {});
  }

  Eigen::Isometry3d laser_pose(const WorldState& state) const {
    const LaserPlane plane = laser_plane(world.robot, state.X_WR);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = plane.p_WS;
    pose.linear() = plane.R_WS;
    return pose;
  }

  ViewCamera camera(const Eigen::Isometry3d& X_WS) const {
    if (options.view != View::kLaser) return fixed_camera();
    // The robot itself is nearer than what is shown.
    const double near_m = world.robot.X_RS.p_m.norm() + world.robot.radius_m + 0.02;
    const DepthRange depth{near_m, near_m + 2.0 * bounds.diagonal().norm()};
    return laser_camera(X_WS, depth, {options.width_px, options.height_px});
  }

  // In the plan nothing may hide the scan; along the beams they would only make a mess.
  OverlayStyle overlay_style() const {
    OverlayStyle style;
    style.scale = options.height_px / 720.0;
    style.beams = options.beams && options.view != View::kLaser;
    style.ribbon_m = options.view == View::kLaser ? 0.05 : 0.0;
    return style;
  }
  double reach_m() const { return std::ceil(0.6 * bounds.sizes().head<2>().norm()); }
  bool has_plan_scale() const { return options.view == View::kTop && options.grid != Grid::kPolar; }

  // Of the polar grid. Who looks along the laser's plane sees it as a line, and so gets the floor below it.
  Eigen::Isometry3d grid_pose(const Eigen::Isometry3d& X_WS) const {
    if (options.view != View::kLaser) return X_WS;
    const Eigen::Vector3d ahead = X_WS.linear().col(0);
    Eigen::Isometry3d pose(Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ()));
    pose.translation() << X_WS.translation().head<2>(), 0.0;
    return pose;
  }

  // Under what was measured.
  void draw_grid(ScenePen& pen, const Eigen::Isometry3d& X_WS) const {
    const double scale = options.height_px / 720.0;
    if (options.grid == Grid::kPolar) draw_polar_grid(pen, grid_pose(X_WS), reach_m(), scale);
    if (options.grid == Grid::kCartesian && !has_plan_scale()) draw_cartesian_grid(pen, bounds, scale);
  }

  InkOptions ink() const { return {.hidden_ratio = options.view == View::kTop ? 1.0 : 0.28}; }

  World world;
  PictureOptions options;
  Eigen::AlignedBox3d bounds;
  ModelPtr model;
  DataPtr data;
  SceneRenderer renderer;
};

ScenePainter::ScenePainter(const World& world, const PictureOptions& options)
    : impl_(std::make_unique<Impl>(world, options)) {}

ScenePainter::~ScenePainter() = default;

Image ScenePainter::paint(const WorldState& state, const Sight& sight, const std::string& caption) {
  const auto& [scan, features, truth] = sight;
  Impl& self = *impl_;
  pose_actors(self.world, state, *self.model, *self.data);
  const Eigen::Isometry3d X_WS = self.laser_pose(state);
  const ViewCamera camera = self.camera(X_WS);
  const RenderedScene scene = self.renderer.render(*self.data, camera);

  Canvas canvas(scene.image);
  ScenePen pen(canvas, camera, scene.depth_m, self.ink());
  self.draw_grid(pen, X_WS);
  draw_scan(pen, X_WS, scan, self.overlay_style());
  if (truth != nullptr && self.options.truth) draw_truth(pen, X_WS, *truth, self.overlay_style().scale);
  if (self.options.features) draw_features(pen, X_WS, features, self.overlay_style());
  if (self.options.grid == Grid::kPolar)
    label_polar_grid(canvas, camera, self.grid_pose(X_WS), self.reach_m());
  if (truth != nullptr && self.options.labels) draw_labels(canvas, camera, X_WS, *truth);
  draw_caption(canvas, caption);
  draw_legend(canvas, features, self.options.view == View::kTop ? "" : "floor tiles: 1 m");
  if (self.has_plan_scale()) draw_plan_scale(canvas, camera);
  return canvas.image();
}

}  // namespace scanbed::sim
