// SPDX-License-Identifier: MIT
#include "sim/render/scene_grid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "core/geometry/angles.hpp"
#include "sim/render/feature_colors.hpp"
#include "sim/render/picture_frame.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector3d;

constexpr int kMostRings = 8;

Vector3d on_floor(double range_m, double bearing_rad) {
  return {range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad), 0.0};
}

}  // namespace

double ring_step_m(double reach_m) {
  return round_step_m(std::max(1.0, reach_m / kMostRings));
}

void draw_cartesian_grid(ScenePen& pen, const Eigen::AlignedBox3d& bounds, double scale) {
  std::vector<ScenePen::Polyline3> lines;
  const Eigen::Vector2i least_m = bounds.min().head<2>().array().floor().cast<int>();
  const Eigen::Vector2i most_m = bounds.max().head<2>().array().ceil().cast<int>();
  const auto point = [](int x_m, int y_m) { return Vector3d(x_m, y_m, 0.0); };
  for (int x_m = least_m.x(); x_m <= most_m.x(); ++x_m) {
    lines.push_back({point(x_m, least_m.y()), point(x_m, most_m.y())});
  }
  for (int y_m = least_m.y(); y_m <= most_m.y(); ++y_m) {
    lines.push_back({point(least_m.x(), y_m), point(most_m.x(), y_m)});
  }
  pen.stroke_all(lines, {kGridColor, 1.2 * scale});
}

void draw_polar_grid(ScenePen& pen, const Eigen::Isometry3d& X_WS, double reach_m, double scale) {
  constexpr int kEdgesPerRing = 180;
  constexpr int kNumRays = 12;
  std::vector<ScenePen::Polyline3> lines;
  const double step_m = ring_step_m(reach_m);
  const int num_rings = static_cast<int>(reach_m / step_m + 1e-9);
  for (int ring = 1; ring <= num_rings; ++ring) {
    ScenePen::Polyline3& line = lines.emplace_back();
    for (int i = 0; i <= kEdgesPerRing; ++i) {
      line.push_back(X_WS * on_floor(ring * step_m, 2.0 * kPi * i / kEdgesPerRing));
    }
  }
  for (int i = 0; i < kNumRays; ++i) {
    const double bearing_rad = 2.0 * kPi * i / kNumRays;
    lines.push_back(
        {X_WS * on_floor(0.5 * step_m, bearing_rad), X_WS * on_floor(num_rings * step_m, bearing_rad)});
  }
  pen.stroke_all(lines, {kGridColor, 1.2 * scale});
}

void label_polar_grid(Canvas& canvas, const ViewCamera& camera, const Eigen::Isometry3d& X_WS,
                      double reach_m) {
  const double scale = picture_scale(canvas);
  const TextStyle style{{0.25, 0.27, 0.32, 1.0}, 11.5 * scale};
  const Eigen::Vector2d size_px(40.0 * scale, 14.0 * scale);
  const double step_m = ring_step_m(reach_m);
  Eigen::AlignedBox2d taken_px;
  for (int ring = 1; ring * step_m <= reach_m + 1e-9; ++ring) {
    const std::optional<Projection> projection = camera.project(X_WS * on_floor(ring * step_m, 0.0));
    if (!projection) continue;
    const Eigen::Vector2d corner_px = projection->at_px + Eigen::Vector2d(4.0 * scale, -4.0 * scale);
    const Eigen::AlignedBox2d box(corner_px - Eigen::Vector2d(0.0, size_px.y()),
                                  corner_px + Eigen::Vector2d(size_px.x(), 0.0));
    // Far away rings lie close together, and beyond the middle stands something else.
    if (!middle_of(canvas).contains(box) || taken_px.intersects(box)) continue;
    taken_px.extend(box);
    std::ostringstream text;
    text << ring * step_m << " m";
    canvas.text(corner_px, text.str(), style);
  }
}

}  // namespace scanbed::sim
