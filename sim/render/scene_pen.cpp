// SPDX-License-Identifier: MIT
#include "sim/render/scene_pen.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/errors/ensure.hpp"

namespace scanbed::sim {

ScenePen::ScenePen(Canvas& canvas, const ViewCamera& camera, const std::vector<float>& depth_m,
                   const InkOptions& options)
    : canvas_(canvas), camera_(camera), depth_m_(depth_m), options_(options) {
  SCANBED_ENSURE(depth_m.size() == static_cast<std::size_t>(camera.width_px) * camera.height_px);
  SCANBED_ENSURE(canvas.width_px() == camera.width_px && canvas.height_px() == camera.height_px);
}

void ScenePen::stroke(const Polyline3& points_W, const Stroke& style) {
  stroke_all({points_W}, style);
}

void ScenePen::stroke_all(const std::vector<Polyline3>& lines_W, const Stroke& style) {
  seen_.clear();
  hidden_.clear();
  for (const Polyline3& points_W : lines_W) trace(points_W);
  Stroke faint = style;
  faint.color[3] *= options_.hidden_ratio;
  canvas_.stroke(hidden_, faint);
  canvas_.stroke(seen_, style);
}

void ScenePen::dots(const Polyline3& points_W, double radius_px, const Rgba& color) {
  Canvas::Polyline seen;
  Canvas::Polyline hidden;
  for (const Eigen::Vector3d& p_WQ : points_W) {
    const std::optional<Projection> projection = camera_.project(p_WQ);
    if (projection) (is_seen(*projection) ? seen : hidden).push_back(projection->at_px);
  }
  Rgba faint = color;
  faint[3] *= options_.hidden_ratio;
  canvas_.dots(hidden, radius_px, faint);
  canvas_.dots(seen, radius_px, color);
}

bool ScenePen::is_seen(const Projection& projection) const {
  if (options_.hidden_ratio >= 1.0) return true;
  // Echoes lie in the middle of the drawn wall's thickness, and fitted circles a little inside their columns.
  constexpr double kSkin_m = 0.12;
  // Along a wall seen at a grazing angle that is still much depth, but few pixels: neighbours count as well.
  const double around_px = camera_.height_px / 240.0;
  const double deepest_m = std::max({
      depth_at(projection.at_px),
      depth_at(projection.at_px + Eigen::Vector2d(around_px, 0.0)),
      depth_at(projection.at_px - Eigen::Vector2d(around_px, 0.0)),
      depth_at(projection.at_px + Eigen::Vector2d(0.0, around_px)),
      depth_at(projection.at_px - Eigen::Vector2d(0.0, around_px)),
  });
  return projection.depth_m <= deepest_m + kSkin_m;
}

double ScenePen::depth_at(const Eigen::Vector2d& at_px) const {
  const double column = std::floor(at_px.x());
  const double row = std::floor(at_px.y());
  if (!(column >= 0.0 && row >= 0.0 && column < camera_.width_px && row < camera_.height_px)) {
    return std::numeric_limits<double>::infinity();
  }
  return depth_m_[static_cast<std::size_t>(row) * camera_.width_px + static_cast<std::size_t>(column)];
}

void ScenePen::trace(const Polyline3& points_W) {
  constexpr double kMaxSteps = 2000.0;
  for (std::size_t i = 0; i + 1 < points_W.size(); ++i) {
    const Eigen::Vector3d edge_m = points_W[i + 1] - points_W[i];
    const int num_steps =
        static_cast<int>(std::clamp(std::ceil(edge_m.norm() / options_.step_m), 1.0, kMaxSteps));
    std::optional<Projection> from = camera_.project(points_W[i]);
    for (int step = 1; step <= num_steps; ++step) {
      const std::optional<Projection> to =
          camera_.project(points_W[i] + static_cast<double>(step) / num_steps * edge_m);
      if (from && to) add_piece(*from, *to, step > 1);
      from = to;
    }
  }
}

void ScenePen::add_piece(const Projection& from, const Projection& to, bool same_edge) {
  const Projection middle{0.5 * (from.at_px + to.at_px), 0.5 * (from.depth_m + to.depth_m)};
  std::vector<Canvas::Polyline>& lines = is_seen(middle) ? seen_ : hidden_;
  const bool goes_on = !lines.empty() && lines.back().back() == from.at_px;
  if (!goes_on) lines.push_back({from.at_px});
  // What is straight in the world is straight in the picture: one long stroke costs less than its pieces.
  if (goes_on && same_edge) {
    lines.back().back() = to.at_px;
  } else {
    lines.back().push_back(to.at_px);
  }
}

}  // namespace scanbed::sim
