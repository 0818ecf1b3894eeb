// SPDX-License-Identifier: MIT
// Ideal planar scans of a hall: the angular z-buffer and, in the same run, one b2World::RayCast for each
// beam.
#include "sim/planar/ray_caster.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/support/hall_world.hpp"
#include "sim/planar/planar_engine.hpp"
#include "tests/support/b2_reference_caster.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kReach_m = 20.0;

/// The benches' hall at time 0: 36 shapes.
PlanarSlice hall() {
  return PlanarEngine(bench::hall_world()).slice();
}

/// A hall of 14 m by 9 m with `num_shapes` shapes: four walls, then columns and short walls on a grid in
/// front of the laser. The more there are, the more of them are hidden.
PlanarSlice crowded_hall(int num_shapes) {
  PlanarSlice slice;
  const Vector2d corners[] = {{-7, 0}, {7, 0}, {7, 9}, {-7, 9}};
  for (int i = 0; i < 4; ++i) slice.segments.push_back({corners[i], corners[(i + 1) % 4], i});
  const int num_inside = num_shapes - 4;
  const int num_columns = static_cast<int>(std::ceil(std::sqrt(1.5 * num_inside)));
  const double apart_m = 13.0 / num_columns;
  const double size_m = std::min(0.25, 0.2 * apart_m);
  for (int i = 0; i < num_inside; ++i) {
    const int row = i / num_columns;
    const Vector2d place(-6.5 + (i % num_columns + 0.5 + 0.3 * (row % 2)) * apart_m, 1.5 + row * apart_m);
    if (i % 3 != 0) slice.discs.push_back({place, size_m, 4 + i});
    if (i % 3 == 0) slice.segments.push_back({place, place + Vector2d(2 * size_m, size_m), 4 + i});
  }
  return slice;
}

ScanGeometry half_turn(int num_beams) {
  ScanGeometry geometry;
  geometry.num_beams = num_beams;
  geometry.step_rad = kPi / (num_beams - 1);
  return geometry;
}

const Pose2 kX_WS{{0.1, 0.45}, kPi / 2};

void run_caster(benchmark::State& state, const PlanarSlice& slice, int num_beams) {
  RayCaster caster(half_turn(num_beams));
  while (state.KeepRunning()) {
    caster.cast(slice, kX_WS);
    benchmark::DoNotOptimize(caster.ranges_m().data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * num_beams);
}

void run_box2d(benchmark::State& state, const PlanarSlice& slice) {
  const test::B2ReferenceCaster reference(slice);
  const ScanGeometry geometry;
  std::vector<Vector2d> directions;
  directions.reserve(geometry.num_beams);
  for (int i = 0; i < geometry.num_beams; ++i) {
    const double bearing_W_rad = kX_WS.theta_rad + geometry.bearing_rad(i);
    directions.emplace_back(std::cos(bearing_W_rad), std::sin(bearing_W_rad));
  }
  while (state.KeepRunning()) {
    for (const Vector2d& u : directions) benchmark::DoNotOptimize(reference.cast(kX_WS.p_m, u, kReach_m));
  }
  state.SetItemsProcessed(state.iterations() * geometry.num_beams);
}

void planar_scan_of_the_hall(benchmark::State& state) {
  run_caster(state, hall(), 361);
}
BENCHMARK(planar_scan_of_the_hall);

void box2d_ray_casts_in_the_hall(benchmark::State& state) {
  run_box2d(state, hall());
}
BENCHMARK(box2d_ray_casts_in_the_hall);

void planar_scan_by_number_of_beams(benchmark::State& state) {
  run_caster(state, hall(), static_cast<int>(state.range(0)));
}
BENCHMARK(planar_scan_by_number_of_beams)->Arg(181)->Arg(361)->Arg(722)->Arg(1444)->Arg(3610)->Arg(14440);

void planar_scan_by_number_of_shapes(benchmark::State& state) {
  run_caster(state, crowded_hall(static_cast<int>(state.range(0))), 361);
}
BENCHMARK(planar_scan_by_number_of_shapes)->Arg(10)->Arg(35)->Arg(100)->Arg(300)->Arg(1000);

}  // namespace
}  // namespace scanbed::sim

BENCHMARK_MAIN();
