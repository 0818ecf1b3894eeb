// SPDX-License-Identifier: MIT
#include "core/geometry/line_fit.hpp"

#include <cmath>

namespace scanbed {

void LineMoments::add(double x_m, double y_m) {
  num_points += 1.0;
  x += x_m;
  y += y_m;
  xx += x_m * x_m;
  xy += x_m * y_m;
  yy += y_m * y_m;
}

LineMoments operator-(const LineMoments& a, const LineMoments& b) {
  return {a.num_points - b.num_points, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}

LineFit fit_line(const LineMoments& m) {
  const double n = m.num_points;
  const Eigen::Vector2d centroid_m(m.x / n, m.y / n);
  const double sxx = m.xx - m.x * centroid_m.x();
  const double sxy = m.xy - m.x * centroid_m.y();
  const double syy = m.yy - m.y * centroid_m.y();
  // Eigenvector of the larger eigenvalue of the scatter [sxx sxy; sxy syy], from the half-angle of its
  // principal axis.
  const double angle_rad = 0.5 * std::atan2(2.0 * sxy, sxx - syy);
  return {centroid_m, {std::cos(angle_rad), std::sin(angle_rad)}};
}

}  // namespace scanbed
