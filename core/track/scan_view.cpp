// SPDX-License-Identifier: MIT
#include "core/track/scan_view.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

struct Counts {
  int nearer = 0;
  int there = 0;
  int farther = 0;
};

}  // namespace

PlaceView view_of(const LaserScan& scan, const Eigen::Vector2d& p_m, double radius_m) {
  const double distance_m = p_m.norm();
  const double step_rad = std::abs(scan.geometry.step_rad);
  if (!(distance_m > radius_m) || !(step_rad > 0.0) || scan.num_beams() == 0) return PlaceView::kOutOfView;
  const double turn = 2.0 * kPi / step_rad;
  const double from_first_rad = std::atan2(p_m.y(), p_m.x()) - scan.geometry.first_rad;
  const double unwrapped = from_first_rad / scan.geometry.step_rad;
  const double middle = unwrapped - turn * std::floor((unwrapped + 0.5) / turn);
  // Half the disc is enough: its rim is where other things begin.
  const double half_width = 0.5 * std::asin(std::min(1.0, radius_m / distance_m)) / step_rad;
  const double first = std::max(0.0, std::round(middle - half_width));
  const double last = std::min(scan.num_beams() - 1.0, std::round(middle + half_width));
  Counts counts;
  for (int beam = static_cast<int>(first); beam <= static_cast<int>(last); ++beam) {
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

}  // namespace scanbed
