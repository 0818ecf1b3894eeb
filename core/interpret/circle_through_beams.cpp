// SPDX-License-Identifier: MIT
#include "core/interpret/circle_through_beams.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace scanbed {

void CircleThroughBeams::add(const LaserScan& scan, const BeamSpan& beams) {
  for (int beam = std::max(0, beams.first); beam <= std::min(beams.last, scan.num_beams() - 1); ++beam) {
    if (!scan.has_echo(beam)) continue;
    const double bearing_rad = scan.geometry.bearing_rad(beam);
    const Eigen::Vector2d p_m =
        scan.range_m[beam] * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
    const Eigen::Vector2d from_center_m = p_m - fit_.center_m;
    const double distance_m = from_center_m.norm();
    // Echoes far off the circle are not of it: something stands before it, or the beam passes it.
    if (distance_m == 0.0 || std::abs(distance_m - fit_.radius_m) > 0.3 * fit_.radius_m) continue;
    const Eigen::Vector3d row(-from_center_m.x() / distance_m, -from_center_m.y() / distance_m, -1.0);
    matrix_ += row * row.transpose();
    side_ -= row * (distance_m - fit_.radius_m);
  }
}

std::optional<double> CircleThroughBeams::step() {
  const Eigen::Matrix3d matrix = matrix_;
  const Eigen::Vector3d side = side_;
  matrix_.setZero();
  side_.setZero();
  const Eigen::LDLT<Eigen::Matrix3d> solver(matrix);
  if (!(solver.vectorD().minCoeff() > 1e-6)) return std::nullopt;
  const Eigen::Vector3d change = solver.solve(side);
  fit_.center_m += change.head<2>();
  fit_.radius_m += change.z();
  return change.head<2>().norm();
}

}  // namespace scanbed
