// SPDX-License-Identifier: MIT
#include "core/interpret/corners.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/cross.hpp"
#include "core/geometry/polar.hpp"
#include "core/interpret/gap_view.hpp"
#include "core/interpret/piece_order.hpp"

namespace scanbed {
namespace {

constexpr int kMaxBeamsBetween = 4;  // echoes at a corner that neither piece took
constexpr double kMinPiece_m = 0.10;
constexpr double kMaxUnseen_m = 1.0;

// How far along its line a piece may go on between its end and a beam that saw it no more: where beams are
// far apart, or graze it, a corner can be that far from its last echo.
double unseen_m(const Line& line, const Eigen::Vector2d& end_m, double bearing_rad) {
  const WallPlane plane = plane_through(line);
  const double cosine = plane.normal.dot(polar(bearing_rad, 1.0));
  if (cosine * plane.distance_m <= 0.0) return kMaxUnseen_m;  // that beam never meets it
  return std::min((polar(bearing_rad, plane.distance_m / cosine) - end_m).norm(), kMaxUnseen_m);
}

// Where both lines meet, if that is near the end of a and the beginning of b, as far as the beams tell.
std::optional<Eigen::Vector2d> meeting_point(const Line& a, const Line& b, const ScanGeometry& geometry,
                                             const InterpretOptions& options) {
  const Eigen::Vector2d along_a_m = a.right_m - a.left_m;
  const Eigen::Vector2d along_b_m = b.right_m - b.left_m;
  if (std::min(along_a_m.norm(), along_b_m.norm()) < kMinPiece_m) return std::nullopt;
  const double sine = cross(along_a_m, along_b_m) / (along_a_m.norm() * along_b_m.norm());
  if (std::abs(sine) < std::sin(options.min_corner_rad)) return std::nullopt;
  const double share = cross(b.left_m - a.left_m, along_b_m) / cross(along_a_m, along_b_m);
  const Eigen::Vector2d corner_m = a.left_m + share * along_a_m;
  // By one beam more than those that met the other wall: at a corner an echo may be taken for either's.
  const double unseen_a_m = unseen_m(a, a.right_m, geometry.bearing_rad(b.beams.first + 1));
  const double unseen_b_m = unseen_m(b, b.left_m, geometry.bearing_rad(a.beams.last - 1));
  if ((corner_m - a.right_m).norm() > options.corner_reach_m + unseen_a_m) return std::nullopt;
  if ((corner_m - b.left_m).norm() > options.corner_reach_m + unseen_b_m) return std::nullopt;
  return corner_m;
}

}  // namespace

void find_corners(const std::vector<Line>& lines, const LaserScan& scan, const InterpretOptions& options,
                  Scene& scene) {
  const int num_lines = static_cast<int>(lines.size());
  const PieceOrder order(scan, num_lines);
  for (int i = 0; i < num_lines; ++i) {
    if (order.num_after(i) == 0) continue;
    const int k = order.after(i, 1);
    const BeamSpan between = order.between(lines[i], lines[k]);
    if (between.last - between.first + 1 > kMaxBeamsBetween) continue;
    const auto corner_m = meeting_point(lines[i], lines[k], scan.geometry, options);
    if (!corner_m) continue;
    const Eigen::Vector2d into_walls =
        (lines[i].left_m - *corner_m).normalized() + (lines[k].right_m - *corner_m).normalized();
    scene.objects.push_back({.kind = SceneKind::kCorner,
                             .center_m = *corner_m,
                             .is_outer = into_walls.dot(*corner_m) > 0.0,
                             .score = std::min(lines[i].score, lines[k].score),
                             .first_from = static_cast<int>(scene.from.size()),
                             .num_from = 2});
    scene.from.push_back({Primitive::kLine, i});
    scene.from.push_back({Primitive::kLine, k});
  }
}

}  // namespace scanbed
