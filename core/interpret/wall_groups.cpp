// SPDX-License-Identifier: MIT
#include "core/interpret/wall_groups.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/interpret/gap_view.hpp"

namespace scanbed {
namespace {

constexpr int kNoLine = -1;
constexpr double kSpread = 0.01;          // error of a piece's direction: widens the offset with distance
constexpr double kMaxOverlap_m = 0.05;    // pieces of one wall do not stand before each other
constexpr double kMinDirection_m = 0.05;  // a shorter piece has none

double length_m(const Line& line) {
  return (line.right_m - line.left_m).norm();
}

// Of a point across the line of a piece.
double offset_m(const Line& line, const Eigen::Vector2d& p_m) {
  const WallPlane plane = plane_through(line);
  return std::abs(plane.normal.dot(p_m) - plane.distance_m);
}

// The free space between piece a and the later piece b, along a's line; negative where they overlap.
double gap_m(const Line& a, const Line& b) {
  const Eigen::Vector2d along = (a.right_m - a.left_m).normalized();
  return along.dot(b.left_m - a.right_m);
}

bool is_collinear(const Line& a, const Line& b, const InterpretOptions& options) {
  if (std::min(length_m(a), length_m(b)) < kMinDirection_m) return false;
  const Line& longer = length_m(a) >= length_m(b) ? a : b;
  const Line& shorter = length_m(a) >= length_m(b) ? b : a;
  const Eigen::Vector2d middle_m = (longer.left_m + longer.right_m) / 2;
  const auto lies_near = [&](const Eigen::Vector2d& p_m) {
    const double beyond_m = std::max(0.0, (p_m - middle_m).norm() - length_m(longer) / 2);
    return offset_m(longer, p_m) <= options.wall_offset_m + kSpread * beyond_m;
  };
  return lies_near(shorter.left_m) && lies_near(shorter.right_m);
}

// Whether the later piece b may belong to a's wall.
bool continues(const Line& a, const Line& b, const InterpretOptions& options) {
  const double between_m = gap_m(a, b);
  return between_m >= -kMaxOverlap_m && between_m <= options.max_wall_gap_m && is_collinear(a, b, options);
}

void add_door(const Line& a, const Line& b, GapView view, Scene& scene) {
  SceneObject door{.kind = SceneKind::kDoor};
  door.left_m = a.right_m;
  door.right_m = b.left_m;
  door.center_m = (door.left_m + door.right_m) / 2;
  door.is_open = view == GapView::kOpen;
  door.score = std::min(a.score, b.score);
  door.first_from = static_cast<int>(scene.from.size());
  scene.objects.push_back(door);
}

}  // namespace

void WallGroups::find(const LaserScan& scan, const std::vector<Line>& lines, const InterpretOptions& options,
                      Scene& scene) {
  next_.assign(lines.size(), kNoLine);
  is_later_.assign(lines.size(), 0);
  longest_.resize(lines.size());
  std::iota(longest_.begin(), longest_.end(), 0);
  link(scan, lines, options, scene);
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    if (is_later_[i] == 0) add_wall(lines, i, options, scene);
  }
}

// On the line of the wall's longest piece too, or a curve would be one wall, bit by bit.
int WallGroups::next_of(int piece, const std::vector<Line>& lines, const PieceOrder& order,
                        const InterpretOptions& options) const {
  for (int num_on = 1; num_on <= order.num_after(piece); ++num_on) {
    const int k = order.after(piece, num_on);
    if (is_later_[k] == 0 && continues(lines[piece], lines[k], options) &&
        is_collinear(lines[longest_[piece]], lines[k], options)) {
      return k;
    }
  }
  return kNoLine;
}

// Each piece with the next one that lies on its line, unless they are too far apart or a wide opening is
// between.
void WallGroups::link(const LaserScan& scan, const std::vector<Line>& lines, const InterpretOptions& options,
                      Scene& scene) {
  const int num_lines = static_cast<int>(lines.size());
  const PieceOrder order(scan, num_lines);
  for (int i = 0; i < num_lines; ++i) {
    const int k = next_of(i, lines, order, options);
    if (k == kNoLine) continue;
    const GapView view = gap_view(scan, order.between(lines[i], lines[k]), plane_through(lines[i]));
    const double between_m = gap_m(lines[i], lines[k]);
    if (view == GapView::kOpen && between_m > options.max_door_m) continue;
    const bool is_door = between_m >= options.min_door_m && between_m <= options.max_door_m;
    if (is_door && (view == GapView::kOpen || view == GapView::kRecess)) {
      add_door(lines[i], lines[k], view, scene);
      scene.from.push_back({Primitive::kLine, i});
      scene.from.push_back({Primitive::kLine, k});
      scene.objects.back().num_from = 2;
    }
    next_[i] = k;
    is_later_[k] = 1;
    longest_[k] = length_m(lines[k]) > length_m(lines[longest_[i]]) ? k : longest_[i];
  }
}

void WallGroups::add_wall(const std::vector<Line>& lines, int first, const InterpretOptions& options,
                          Scene& scene) {
  SceneObject wall{.kind = SceneKind::kWall, .left_m = lines[first].left_m};
  wall.first_from = static_cast<int>(scene.from.size());
  double measured_m = 0.0;
  double score_m = 0.0;
  for (int i = first; i != kNoLine; i = next_[i]) {
    measured_m += length_m(lines[i]);
    score_m += lines[i].score * length_m(lines[i]);
    wall.right_m = lines[i].right_m;
    scene.from.push_back({Primitive::kLine, i});
    ++wall.num_from;
  }
  if (measured_m < options.min_wall_m || measured_m <= 0.0) {
    scene.from.resize(wall.first_from);
    return;
  }
  wall.score = score_m / measured_m;
  wall.center_m = (wall.left_m + wall.right_m) / 2;
  scene.objects.push_back(wall);
}

}  // namespace scanbed
