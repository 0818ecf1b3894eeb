// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_beams.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

// Farther echoes say no more about a leg's surroundings.
constexpr double kMaxRange_m = 100.0;
constexpr double kMinStep_rad = 1e-5;  // a geometry without steps must not divide by them

}  // namespace

void LegBeams::resize_echoes(std::size_t num_echoes) {
  beam.resize(num_echoes);
  for (std::vector<double>* values : {&echo_range_m, &echo_x_m, &echo_y_m}) values->resize(num_echoes);
}

void LegBeamReader::read(const LaserScan& scan, LegBeams& beams) {
  const int num_beams = scan.num_beams();
  const ScanGeometry& g = scan.geometry;
  directions_.follow(scan);
  beams.num_beams = num_beams;
  beams.step_rad = std::abs(g.step_rad) > kMinStep_rad ? std::abs(g.step_rad) : kMinStep_rad;
  const int padded = (num_beams + kBlock - 1) / kBlock * kBlock + kBlock;
  for (std::vector<float>* values : {&beams.range_m, &beams.x_m, &beams.y_m}) {
    values->resize(padded);
    std::fill(values->begin() + num_beams, values->end(), LegBeams::kNothing_m);
  }
  beams.resize_echoes(num_beams);
  std::size_t n = 0;
  for (int i = 0; i < num_beams; ++i) {
    const double range_m = scan.range_m[i];
    const double x_m = range_m * directions_.x(i);
    const double y_m = range_m * directions_.y(i);
    const bool is_echo = range_m > 0.0 && range_m <= kMaxRange_m && std::isfinite(x_m + y_m);
    beams.range_m[i] = is_echo ? static_cast<float>(range_m) : LegBeams::kNothing_m;
    beams.x_m[i] = is_echo ? static_cast<float>(x_m) : LegBeams::kNothing_m;
    beams.y_m[i] = is_echo ? static_cast<float>(y_m) : LegBeams::kNothing_m;
    // What is no echo is written over by the next one.
    beams.beam[n] = i;
    beams.echo_range_m[n] = range_m;
    beams.echo_x_m[n] = x_m;
    beams.echo_y_m[n] = y_m;
    n += is_echo ? 1 : 0;
  }
  beams.resize_echoes(n);
}

}  // namespace scanbed
