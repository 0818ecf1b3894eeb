// SPDX-License-Identifier: MIT
#include "sim/render/label_places.hpp"

#include <limits>
#include <utility>

namespace scanbed::sim {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr int kMostRows = 6;  // that a label stands away from its anchor

double common_area(const AlignedBox2d& a, const AlignedBox2d& b) {
  const AlignedBox2d common = a.intersection(b);
  return common.isEmpty() ? 0.0 : common.volume();
}

// Middles of a label to choose from, seen from its anchor; what comes first wins where all else is equal.
std::vector<Vector2d> offsets_of(const Vector2d& size_px) {
  const double row_px = size_px.y();
  const double beside_px = 0.5 * size_px.x() + row_px;
  std::vector<Vector2d> offsets_px;
  for (int row = 1; row <= kMostRows; ++row) {
    for (const double x_px : {0.0, 0.6 * beside_px, -0.6 * beside_px, beside_px, -beside_px}) {
      offsets_px.emplace_back(x_px, -row * row_px);
      offsets_px.emplace_back(x_px, row * row_px);
    }
  }
  offsets_px.emplace_back(beside_px, 0.0);
  offsets_px.emplace_back(-beside_px, 0.0);
  return offsets_px;
}

class Places {
 public:
  Places(std::span<const Label> labels, const AlignedBox2d& picture_px) : picture_px_(picture_px) {
    for (const Label& label : labels) {
      const Vector2d half_px = Vector2d::Constant(0.5 * label.size_px.y());
      anchors_px_.emplace_back(label.anchor_px - half_px, label.anchor_px + half_px);
    }
  }

  void add(const Label& label) {
    AlignedBox2d best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const Vector2d& offset_px : offsets_of(label.size_px)) {
      const Vector2d middle_px = label.anchor_px + offset_px;
      const AlignedBox2d box(middle_px - 0.5 * label.size_px, middle_px + 0.5 * label.size_px);
      const double cost = cost_of(box) + offset_px.norm();
      if (cost >= best_cost) continue;
      best = box;
      best_cost = cost;
    }
    taken_px_.push_back(best);
  }

  std::vector<AlignedBox2d> taken() && { return std::move(taken_px_); }

 private:
  // In square pixels; to be unreadable, even by a sliver, is worse than to cover something.
  double cost_of(const AlignedBox2d& box) const {
    const auto unreadable = [&](double area_px2) { return area_px2 > 0.0 ? box.volume() + area_px2 : 0.0; };
    double cost = unreadable(box.volume() - common_area(box, picture_px_));
    for (const AlignedBox2d& label : taken_px_) cost += unreadable(common_area(box, label));
    for (const AlignedBox2d& anchor : anchors_px_) cost += common_area(box, anchor);
    return cost;
  }

  AlignedBox2d picture_px_;
  std::vector<AlignedBox2d> anchors_px_;
  std::vector<AlignedBox2d> taken_px_;
};

}  // namespace

std::vector<AlignedBox2d> label_places(std::span<const Label> labels, const AlignedBox2d& picture_px) {
  Places places(labels, picture_px);
  for (const Label& label : labels) places.add(label);
  return std::move(places).taken();
}

}  // namespace scanbed::sim
