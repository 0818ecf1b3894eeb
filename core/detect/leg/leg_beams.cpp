// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_beams.hpp"

#include <cmath>

namespace scanbed {
namespace {

// Farther echoes say no more about a leg's surroundings, and would cost the sums their digits.
constexpr double kMaxRange_m = 100.0;
constexpr double kMinStep_rad = 1e-5;  // a geometry without steps must not divide by them

EchoSums plus(EchoSums sums, double x, double y, double range, double step) {
  const double z = x * x + y * y;
  sums.x += x;
  sums.y += y;
  sums.range += range;
  sums.xx += x * x;
  sums.xy += x * y;
  sums.yy += y * y;
  sums.range2 += range * range;
  sums.step2 += step * step;
  sums.xz += x * z;
  sums.yz += y * z;
  sums.zz += z * z;
  return sums;
}

}  // namespace

double LegBeams::distance_m(int a, int b) const {
  return std::hypot(echo_x_m[a] - echo_x_m[b], echo_y_m[a] - echo_y_m[b]);
}

void LegBeamReader::read(const LaserScan& scan, LegBeams& beams) {
  const int num_beams = scan.num_beams();
  const ScanGeometry& g = scan.geometry;
  directions_.follow(scan);
  beams.num_beams = num_beams;
  beams.step_rad = std::abs(g.step_rad) > kMinStep_rad ? std::abs(g.step_rad) : kMinStep_rad;
  const int padded = (num_beams + kBlock - 1) / kBlock * kBlock + kBlock;
  for (std::vector<float>* values : {&beams.range_m, &beams.x_m, &beams.y_m}) {
    values->assign(padded, LegBeams::kNothing_m);
  }
  beams.beam.clear();
  beams.echo_range_m.clear();
  beams.echo_x_m.clear();
  beams.echo_y_m.clear();
  beams.sums.clear();
  beams.sums.emplace_back();
  for (int i = 0; i < num_beams; ++i) {
    const double range_m = scan.range_m[i];
    if (!(range_m > 0.0) || !(range_m <= kMaxRange_m)) continue;
    const double x_m = range_m * directions_.x(i);
    const double y_m = range_m * directions_.y(i);
    if (!std::isfinite(x_m) || !std::isfinite(y_m)) continue;
    const double step_m = beams.beam.empty() ? 0.0 : range_m - beams.echo_range_m.back();
    beams.range_m[i] = static_cast<float>(range_m);
    beams.x_m[i] = static_cast<float>(x_m);
    beams.y_m[i] = static_cast<float>(y_m);
    beams.beam.push_back(i);
    beams.echo_range_m.push_back(range_m);
    beams.echo_x_m.push_back(x_m);
    beams.echo_y_m.push_back(y_m);
    beams.sums.push_back(plus(beams.sums.back(), x_m, y_m, range_m, step_m));
  }
}

}  // namespace scanbed
