// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/render/canvas.hpp"
#include "sim/render/scene_renderer.hpp"
#include "sim/render/view_camera.hpp"

namespace scanbed::sim {

/// How lines that lie in the world show behind things.
struct InkOptions {
  double hidden_ratio =
      0.28;              ///< of the opacity, where something stands in front; 1 ignores what stands there
  double step_m = 0.10;  ///< a line is visible or hidden in pieces of this length at most
};

/// Draws lines and dots that lie in the world onto a rendered scene.
class ScenePen {
 public:
  /// All must outlive the pen.
  ScenePen(Canvas& canvas, const ViewCamera& camera, const std::vector<float>& depth_m,
           const InkOptions& options);

  using Polyline3 = std::vector<Eigen::Vector3d>;

  void stroke(const Polyline3& points_W, const Stroke& style);
  /// As one: where they cross, a translucent colour does not add up.
  void stroke_all(const std::vector<Polyline3>& lines_W, const Stroke& style);
  void dots(const Polyline3& points_W, double radius_px, const Rgba& color);

 private:
  bool is_seen(const Projection& projection) const;
  double depth_at(const Eigen::Vector2d& at_px) const;
  void trace(const Polyline3& points_W);
  void add_piece(const Projection& from, const Projection& to, bool same_edge);

  Canvas& canvas_;
  const ViewCamera& camera_;
  const std::vector<float>& depth_m_;
  InkOptions options_;
  std::vector<Canvas::Polyline> seen_;
  std::vector<Canvas::Polyline> hidden_;
};

}  // namespace scanbed::sim
