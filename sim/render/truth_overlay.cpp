// SPDX-License-Identifier: MIT
#include "sim/render/truth_overlay.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/angles.hpp"
#include "sim/render/feature_colors.hpp"
#include "sim/render/label_places.hpp"
#include "sim/render/picture_frame.hpp"

namespace scanbed::sim {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d lift(const Vector2d& p_SQ) {
  return {p_SQ.x(), p_SQ.y(), 0.0};
}

// In the world's frame.
ScenePen::Polyline3 outline(const Eigen::Isometry3d& X_WS, const ObjectTruth& object) {
  if (object.primitive == Primitive::kLine) return {X_WS * lift(object.from_m), X_WS * lift(object.to_m)};
  constexpr int kNumEdges = 48;
  ScenePen::Polyline3 ring;
  for (int i = 0; i <= kNumEdges; ++i) {
    const double angle_rad = 2.0 * kPi * i / kNumEdges;
    const Vector2d on_ring = object.radius_m * Vector2d(std::cos(angle_rad), std::sin(angle_rad));
    ring.push_back(X_WS * lift(object.center_m + on_ring));
  }
  return ring;
}

bool is_shown(const ObjectTruth& object) {
  return object.num_clean_beams > 0 && object.primitive != Primitive::kNone;
}

// From what is named to the labels that stand apart from it.
std::vector<Canvas::Polyline> leaders(std::span<const Label> labels, std::span<const AlignedBox2d> boxes) {
  std::vector<Canvas::Polyline> lines;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Vector2d end_px = labels[i].anchor_px.cwiseMax(boxes[i].min()).cwiseMin(boxes[i].max());
    constexpr double kBeside = 1.2;  // heights of a label; the nearest places are one away
    if ((end_px - labels[i].anchor_px).norm() > kBeside * labels[i].size_px.y()) {
      lines.push_back({labels[i].anchor_px, end_px});
    }
  }
  return lines;
}

}  // namespace

void draw_truth(ScenePen& pen, const Eigen::Isometry3d& X_WS, const Truth& truth, double scale) {
  for (const ObjectTruth& object : truth.objects) {
    if (is_shown(object)) pen.stroke(outline(X_WS, object), {kTruthColor, 1.6 * scale});
  }
}

void draw_labels(Canvas& canvas, const ViewCamera& camera, const Eigen::Isometry3d& X_WS,
                 const Truth& truth) {
  const double scale = picture_scale(canvas);
  const TextStyle halo{{1.0, 1.0, 1.0, 0.8}, 12.0 * scale, true};
  const TextStyle ink{kTruthColor, 12.0 * scale, true};
  const double gap_px = 3.0 * scale;  // on either side, so that neighbours do not read as one
  const AlignedBox2d middle_px = middle_of(canvas);
  std::vector<Label> labels;
  std::vector<std::string> texts;
  for (const ObjectTruth& object : truth.objects) {
    if (!is_shown(object)) continue;
    const bool is_line = object.primitive == Primitive::kLine;
    const Vector2d place_m = is_line ? Vector2d(0.5 * (object.from_m + object.to_m)) : object.center_m;
    const std::optional<Projection> projection = camera.project(X_WS * lift(place_m));
    if (!projection || !middle_px.contains(projection->at_px)) continue;
    labels.push_back(
        {projection->at_px, {canvas.text_width_px(object.id, ink) + 2.0 * gap_px, 14.0 * scale}});
    texts.push_back(object.id);
  }
  const std::vector<AlignedBox2d> boxes = label_places(labels, middle_px);
  canvas.stroke(leaders(labels, boxes), {kTruthColor, scale});
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vector2d at_px(boxes[i].min().x() + gap_px, boxes[i].max().y() - 3.0 * scale);
    for (const Vector2d& off_px : {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1)}) {
      canvas.text(at_px + scale * off_px, texts[i], halo);
    }
    canvas.text(at_px, texts[i], ink);
  }
}

}  // namespace scanbed::sim
