// SPDX-License-Identifier: MIT
#include "sim/world/furniture.hpp"

#include <array>
#include <utility>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kSeatThickness_m = 0.05;

Solid seat(const std::string& id, const std::string& label, const Box& box, double height_m) {
  return {.id = id + ".seat",
          .label = label,
          .shape = box,
          .bottom_m = height_m,
          .top_m = height_m + kSeatThickness_m,
          .material = {}};
}

}  // namespace

std::vector<Solid> bench_parts(const Bench& bench) {
  std::vector<Solid> parts;
  for (const int side : {0, 1}) {
    const Vector2d p_BF((side - 0.5) * bench.feet_apart_m, 0.0);
    parts.push_back({.id = bench.id + ".foot_" + std::to_string(side),
                     .label = bench.label,
                     .shape = Cylinder{bench.X_WB * p_BF, bench.foot_radius_m},
                     .top_m = bench.seat_height_m,
                     .material = {}});
  }
  const Vector2d size_m(bench.feet_apart_m + 2.0 * bench.foot_radius_m, 2.0 * bench.foot_radius_m);
  parts.push_back(seat(bench.id, bench.label, {bench.X_WB, size_m}, bench.seat_height_m));
  return parts;
}

std::vector<Solid> chair_parts(const Chair& chair) {
  constexpr std::array<std::pair<double, double>, 4> kCorners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const double out_m = 0.5 * (chair.size_m - chair.leg_m);
  std::vector<Solid> parts;
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    const Vector2d p_CL(out_m * kCorners[i].first, out_m * kCorners[i].second);
    const Pose2 X_WL{chair.X_WC * p_CL, chair.X_WC.theta_rad};
    parts.push_back({.id = chair.id + ".leg_" + std::to_string(i),
                     .label = chair.label,
                     .shape = Box{X_WL, Vector2d::Constant(chair.leg_m)},
                     .top_m = chair.seat_height_m,
                     .material = {}});
  }
  parts.push_back(
      seat(chair.id, chair.label, {chair.X_WC, Vector2d::Constant(chair.size_m)}, chair.seat_height_m));
  return parts;
}

}  // namespace scanbed::sim
