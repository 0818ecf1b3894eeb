// SPDX-License-Identifier: MIT
// What a simulated scan costs: world moved on, ideal returns, LMS model, words, truth with visibility.
#include "sim/sensor/simulated_lms.hpp"

#include <benchmark/benchmark.h>

#include "bench/support/hall_world.hpp"

namespace scanbed::sim {
namespace {

constexpr RangeSensor::Seconds kNoWait{0.0};

void run_scans(benchmark::State& state, const World& world) {
  SimulationOptions options;
  options.duration_s = 1e6;
  SimulatedLms lms(world, options);
  LaserScan scan;
  while (state.KeepRunning()) {
    if (!lms.next(scan, kNoWait)) state.SkipWithError("the simulation is over");
    benchmark::DoNotOptimize(scan.range_m.data());
  }
  state.SetItemsProcessed(state.iterations());
}

void simulated_scan_of_the_hall(benchmark::State& state) {
  run_scans(state, bench::hall_world());
}
BENCHMARK(simulated_scan_of_the_hall);

// Box2D steps 60 times for each scan.
void simulated_scan_with_a_towed_cylinder(benchmark::State& state) {
  World world = bench::hall_world();
  world.walkers[0].path = {{{-3.0, 2.0}, {3.0, 2.0}, {3.0, 3.0}, {-3.0, 3.0}}, true, 0.4, false};
  world.walkers[0].tow = Tow{};
  world.walkers[0].tow->id = "cylinder";
  run_scans(state, world);
}
BENCHMARK(simulated_scan_with_a_towed_cylinder);

}  // namespace
}  // namespace scanbed::sim

BENCHMARK_MAIN();
