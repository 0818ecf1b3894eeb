// SPDX-License-Identifier: MIT
#include "core/detect/line_corner.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/geometry/cross.hpp"
#include "core/geometry/polar.hpp"

namespace scanbed {
namespace {

constexpr int kMaxBeamsBetween = 4;  // echoes at a corner that neither piece took
constexpr double kMinPiece_m = 0.10;
constexpr double kMaxUnseen_m = 1.0;

// How far along its line a piece may go on between its end and a beam that saw it no more.
double unseen_m(const Eigen::Vector2d& end_m, const Eigen::Vector2d& along_m, double bearing_rad) {
  const Eigen::Vector2d ray = polar(bearing_rad, 1.0);
  const double range_m = cross(end_m, along_m) / cross(ray, along_m);
  if (!(range_m > 0.0)) return kMaxUnseen_m;  // that beam never meets it
  return std::min((range_m * ray - end_m).norm(), kMaxUnseen_m);
}

}  // namespace

std::optional<Eigen::Vector2d> corner_of(const NeighbouringLines& lines, const ScanGeometry& geometry,
                                         const CornerLimits& limits) {
  const auto& [a, b, between] = lines;
  if (between.last - between.first + 1 > kMaxBeamsBetween) return std::nullopt;
  const Eigen::Vector2d along_a_m = a.right_m - a.left_m;
  const Eigen::Vector2d along_b_m = b.right_m - b.left_m;
  if (std::min(along_a_m.norm(), along_b_m.norm()) < kMinPiece_m) return std::nullopt;
  const double sine = cross(along_a_m, along_b_m) / (along_a_m.norm() * along_b_m.norm());
  if (std::abs(sine) < std::sin(limits.min_angle_rad)) return std::nullopt;
  const double share = cross(b.left_m - a.left_m, along_b_m) / cross(along_a_m, along_b_m);
  const Eigen::Vector2d corner_m = a.left_m + share * along_a_m;
  // By one beam more than those that met the other wall: at a corner an echo may be taken for either's.
  const double unseen_a_m = unseen_m(a.right_m, along_a_m, geometry.bearing_rad(between.last + 2));
  const double unseen_b_m = unseen_m(b.left_m, along_b_m, geometry.bearing_rad(between.first - 2));
  if ((corner_m - a.right_m).norm() > limits.reach_m + unseen_a_m) return std::nullopt;
  if ((corner_m - b.left_m).norm() > limits.reach_m + unseen_b_m) return std::nullopt;
  return corner_m;
}

void end_at_corners(std::vector<Line>& lines, const ScanGeometry& geometry) {
  for (std::size_t i = 1; i < lines.size(); ++i) {
    Line& a = lines[i - 1];
    Line& b = lines[i];
    const auto corner_m = corner_of({a, b, {a.beams.last + 1, b.beams.first - 1}}, geometry);
    if (!corner_m) continue;
    a.right_m = *corner_m;
    b.left_m = *corner_m;
  }
}

}  // namespace scanbed
