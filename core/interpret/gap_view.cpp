// SPDX-License-Identifier: MIT
#include "core/interpret/gap_view.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/detect/full_turn.hpp"

namespace scanbed {
namespace {

constexpr int kMinBeams = 3;
constexpr double kNearer_m = 0.08;    // before the wall's line by more than a door's handle
constexpr double kRecess_m = 0.02;    // behind it by more than noise
constexpr double kMaxRecess_m = 0.5;  // a door frame is no deeper
constexpr double kOpen_m = 1.0;       // behind it by so much is another room
constexpr double kMinSlope = 0.05;    // between beam and wall: shallower beams do not tell depths

// How far beams may be counted: behind a scan all around it comes again.
struct Turns {
  int num_beams = 0;
  int num = 1;
};

Turns turns_of(const LaserScan& scan) {
  const int num_in_turn = num_beams_in_turn(scan);
  return num_in_turn > 0 ? Turns{num_in_turn, 2} : Turns{scan.num_beams(), 1};
}

// Depth of a beam's echo behind the wall's line, along the normal; nothing where the beam does not tell.
std::optional<double> depth_m(const LaserScan& scan, int beam, const WallPlane& plane) {
  const double range_m = scan.range_m[beam];
  const double bearing_rad = scan.geometry.bearing_rad(beam);
  const double slope = plane.normal.dot(Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
  if (std::isnan(range_m) || slope < kMinSlope) return std::nullopt;
  return range_m * slope - plane.distance_m;
}

}  // namespace

WallPlane plane_through(const Line& line) {
  const Eigen::Vector2d along = (line.right_m - line.left_m).normalized();
  WallPlane plane{.normal = {-along.y(), along.x()}};
  plane.distance_m = plane.normal.dot((line.left_m + line.right_m) / 2);
  if (plane.distance_m < 0.0) plane = {-plane.normal, -plane.distance_m};
  return plane;
}

GapView gap_view(const LaserScan& scan, const BeamSpan& beams, const WallPlane& plane) {
  int num_nearer = 0;
  int num_recessed = 0;
  int num_open = 0;
  int num_told = 0;
  const Turns turns = turns_of(scan);
  const int last = std::min(beams.last, turns.num * turns.num_beams - 1);
  for (int i = std::max(0, beams.first); i <= last; ++i) {
    const std::optional<double> behind_m = depth_m(scan, i % turns.num_beams, plane);
    if (!behind_m) continue;
    ++num_told;
    if (*behind_m < -kNearer_m) ++num_nearer;
    if (*behind_m > kRecess_m && *behind_m <= kMaxRecess_m) ++num_recessed;
    if (*behind_m > kOpen_m) ++num_open;
  }
  if (num_told < kMinBeams) return GapView::kUnknown;
  if (2 * num_open > num_told) return GapView::kOpen;
  if (2 * num_recessed > num_told) return GapView::kRecess;
  return 2 * num_nearer > num_told ? GapView::kHidden : GapView::kUnknown;
}

}  // namespace scanbed
