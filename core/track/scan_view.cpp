// SPDX-License-Identifier: MIT
#include "core/track/scan_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/detect/features.hpp"
#include "core/geometry/polar.hpp"

namespace scanbed {
namespace {

// The scan's beams within an angle to either side of the way to p; none where last < first.
BeamSpan beams_towards(const LaserScan& scan, const Eigen::Vector2d& p_m, double half_width_rad) {
  const double middle = scan.geometry.beam_towards(std::atan2(p_m.y(), p_m.x()));
  if (!std::isfinite(middle)) return {0, -1};
  const double half_width = half_width_rad / std::abs(scan.geometry.step_rad);
  // Of steps that are next to nothing the numbers of beams are beyond any integer.
  return {static_cast<int>(std::clamp(std::round(middle - half_width), 0.0, 1.0 * scan.num_beams())),
          static_cast<int>(std::clamp(std::round(middle + half_width), -1.0, scan.num_beams() - 1.0))};
}

// From inside the disc, or with a scan without beams, there is nothing to see of it.
bool can_be_seen(const LaserScan& scan, const Eigen::Vector2d& p_m, double radius_m) {
  return p_m.norm() > radius_m && std::abs(scan.geometry.step_rad) > 0.0 && scan.num_beams() > 0;
}

struct Counts {
  int nearer = 0;
  int there = 0;
  int farther = 0;
};

}  // namespace

PlaceView view_of(const LaserScan& scan, const Eigen::Vector2d& p_m, double radius_m) {
  if (!can_be_seen(scan, p_m, radius_m)) return PlaceView::kOutOfView;
  const double distance_m = p_m.norm();
  // Half the disc is enough: its rim is where other things begin.
  const BeamSpan beams = beams_towards(scan, p_m, 0.5 * std::asin(std::min(1.0, radius_m / distance_m)));
  Counts counts;
  for (int beam = beams.first; beam <= beams.last; ++beam) {
    const double range_m = scan.range_m[beam];
    if (std::isnan(range_m)) continue;
    ++(range_m < distance_m - radius_m    ? counts.nearer
       : range_m <= distance_m + radius_m ? counts.there
                                          : counts.farther);
  }
  if (counts.nearer + counts.there + counts.farther == 0) return PlaceView::kOutOfView;
  if (counts.farther > counts.nearer + counts.there) return PlaceView::kEmpty;
  return counts.nearer >= counts.there ? PlaceView::kHidden : PlaceView::kOccupied;
}

int num_echoes_near(const LaserScan& scan, const Eigen::Vector2d& p_m, double radius_m) {
  if (!can_be_seen(scan, p_m, radius_m)) return 0;
  const BeamSpan beams = beams_towards(scan, p_m, std::asin(std::min(1.0, radius_m / p_m.norm())));
  int num_echoes = 0;
  for (int beam = beams.first; beam <= beams.last; ++beam) {
    if (!scan.has_echo(beam)) continue;
    const double bearing_rad = scan.geometry.first_rad + beam * scan.geometry.step_rad;
    if ((polar(bearing_rad, scan.range_m[beam]) - p_m).norm() <= radius_m) ++num_echoes;
  }
  return num_echoes;
}

}  // namespace scanbed
