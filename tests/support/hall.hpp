// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

inline Solid test_bench_foot(const std::string& id, const Eigen::Vector2d& center_m) {
  return {.id = id, .label = "bench", .shape = Cylinder{center_m, 0.25}, .top_m = 0.40};
}

inline Solid test_bench_seat(const std::string& id, const Pose2& X_WB) {
  return {.id = id,
          .label = "bench",
          .shape = Box{X_WB, Eigen::Vector2d(1.9, 0.5)},
          .bottom_m = 0.40,
          .top_m = 0.48};
}

/// A hall of 14 x 9 m after the paper's static test: two columns, two benches, a walker that tows a cylinder,
/// a second walker, the robot at (0, 0.45) looking along y.
inline World test_hall() {
  World world;
  world.solids = {
      {.id = "hall", .label = "wall", .shape = WallChain{{{-7, 0}, {7, 0}, {7, 9}, {-7, 9}}, true}},
      {.id = "col_L", .label = "column", .shape = Cylinder{{-2, 4}, 0.25}},
      {.id = "col_R", .label = "column", .shape = Cylinder{{2, 4}, 0.25}},
      test_bench_foot("bench_L.foot_0", {-4.6, 7.0}),
      test_bench_foot("bench_L.foot_1", {-3.4, 7.0}),
      test_bench_seat("bench_L.seat", {{-4.0, 7.0}, 0.0}),
      test_bench_foot("bench_R.foot_0", {3.4, 7.0}),
      test_bench_foot("bench_R.foot_1", {4.6, 7.0}),
      test_bench_seat("bench_R.seat", {{4.0, 7.0}, 0.0}),
  };
  world.robot.X_WR = {{0.0, 0.45}, kPi / 2};
  world.walkers = {{.id = "student_A", .path = {{{-3.2, 2.8}, {3.2, 2.8}}}, .tow = Tow{.id = "cyl"}},
                   {.id = "student_B", .path = {{{6.6, 2.4}, {4.6, 0.6}}}}};
  return world;
}

inline WalkerState test_stride(int walker, const Pose2& X_WP) {
  WalkerState state{.walker = walker, .present = true, .X_WP = X_WP};
  state.left_foot_m = X_WP * Eigen::Vector2d(0.30, 0.06);
  state.right_foot_m = X_WP * Eigen::Vector2d(-0.28, -0.06);
  state.left_leg_m = X_WP * Eigen::Vector2d(0.21, 0.065);
  state.right_leg_m = X_WP * Eigen::Vector2d(-0.195, -0.065);
  return state;
}

inline WorldState test_hall_state(const World& world) {
  WorldState state;
  state.X_WR = world.robot.X_WR;
  state.walkers = {test_stride(0, {{0.9, 2.8}, 0.0}), test_stride(1, {{4.9, 2.6}, -2.4})};
  state.tows = {{.walker = 0, .present = true, .center_m = {-0.25, 2.8}}};
  return state;
}

/// Ranges to the round things and outer walls of the hall, by the closed forms for circle and line.
inline LaserScan test_hall_scan(const World& world, const WorldState& state) {
  std::vector<std::pair<Eigen::Vector2d, double>> discs;
  for (const Solid& solid : world.solids) {
    if (const auto* cylinder = std::get_if<Cylinder>(&solid.shape))
      discs.emplace_back(cylinder->center_m, cylinder->radius_m);
  }
  for (const WalkerState& walker : state.walkers) {
    discs.emplace_back(walker.left_leg_m, 0.06);
    discs.emplace_back(walker.right_leg_m, 0.06);
  }
  for (const TowState& tow : state.tows) discs.emplace_back(tow.center_m, 0.25);

  LaserScan scan;
  const Pose2 X_WS = state.X_WR * world.robot.X_RS;
  for (int beam = 0; beam < scan.geometry.num_beams; ++beam) {
    const Pose2 ray{X_WS.p_m, X_WS.theta_rad + scan.geometry.bearing_rad(beam)};
    const Eigen::Vector2d u = ray.heading();
    double range_m = 100.0;
    if (std::abs(u.x()) > 1e-9) range_m = std::min(range_m, ((u.x() > 0 ? 7.0 : -7.0) - ray.p_m.x()) / u.x());
    if (u.y() > 1e-9) range_m = std::min(range_m, (9.0 - ray.p_m.y()) / u.y());
    for (const auto& [center_m, radius_m] : discs) {
      const Eigen::Vector2d to = center_m - ray.p_m;
      const double along_m = to.dot(u);
      const double across2 = to.squaredNorm() - along_m * along_m;
      if (along_m > 0.0 && across2 < radius_m * radius_m)
        range_m = std::min(range_m, along_m - std::sqrt(radius_m * radius_m - across2));
    }
    scan.range_m.push_back(range_m);
  }
  return scan;
}

/// What a perfect detector says of that scan, sensor frame.
inline Features test_hall_features(const World& world, const WorldState& state) {
  const Pose2 X_SW = (state.X_WR * world.robot.X_RS).inverse();
  Features features;
  const auto line = [&](const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W) {
    Line wall;
    wall.left_m = X_SW * from_W;
    wall.right_m = X_SW * to_W;
    features.lines.push_back(wall);
  };
  line({7.0, 0.5}, {7.0, 9.0});
  line({-7.0, 9.0}, {7.0, 9.0});
  line({-7.0, 0.5}, {-7.0, 9.0});
  const auto circle = [&](const Eigen::Vector2d& center_W) {
    Circle round;
    round.center_m = X_SW * center_W;
    round.radius_m = 0.25;
    features.circles.push_back(round);
  };
  for (const Solid& solid : world.solids) {
    if (const auto* cylinder = std::get_if<Cylinder>(&solid.shape)) circle(cylinder->center_m);
  }
  for (const TowState& tow : state.tows) circle(tow.center_m);
  for (const WalkerState& walker : state.walkers) {
    for (const Eigen::Vector2d& leg_W : {walker.left_leg_m, walker.right_leg_m}) {
      Leg leg;
      leg.middle_m = X_SW * leg_W;
      features.legs.push_back(leg);
    }
  }
  return features;
}

}  // namespace scanbed::sim
