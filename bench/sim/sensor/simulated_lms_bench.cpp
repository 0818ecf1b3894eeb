// SPDX-License-Identifier: MIT
// What a simulated scan costs: world moved on, ideal returns, sensor model, words, truth with visibility.
#include "sim/sensor/simulated_lms.hpp"

#include <benchmark/benchmark.h>

#include "bench/support/hall_world.hpp"
#include "sim/sensor/sensor_presets.hpp"

namespace scanbed::sim {
namespace {

constexpr RangeSensor::Seconds kNoWait{0.0};

void run_scans(benchmark::State& state, const World& world, const SensorOptions& sensor) {
  SimulatedLms lms(world, {.lms = sensor, .duration_s = 1e6});
  LaserScan scan;
  while (state.KeepRunning()) {
    if (!lms.next(scan, kNoWait)) state.SkipWithError("the simulation is over");
    benchmark::DoNotOptimize(scan.range_m.data());
  }
  state.SetItemsProcessed(state.iterations());
}

World hall_at_rest() {
  World world = bench::hall_world();
  world.walkers.clear();
  return world;
}

void ideal_scan_of_the_hall(benchmark::State& state) {
  run_scans(state, bench::hall_world(), sensor_preset("ideal"));
}
BENCHMARK(ideal_scan_of_the_hall);

void full_lms200_scan_of_the_hall(benchmark::State& state) {
  run_scans(state, bench::hall_world(), sensor_preset("sick_lms200"));
}
BENCHMARK(full_lms200_scan_of_the_hall);

void full_lms200_scan_of_the_hall_at_rest(benchmark::State& state) {
  run_scans(state, hall_at_rest(), sensor_preset("sick_lms200"));
}
BENCHMARK(full_lms200_scan_of_the_hall_at_rest);

// Effects off one by one: what each costs.
void full_lms200_scan_without_spot(benchmark::State& state) {
  SensorOptions sensor = sensor_preset("sick_lms200");
  sensor.effects.spot = 0.0;
  run_scans(state, bench::hall_world(), sensor);
}
BENCHMARK(full_lms200_scan_without_spot);

void full_lms200_scan_by_sectors(benchmark::State& state) {
  SensorOptions sensor = sensor_preset("sick_lms200");
  // Half a turn, and the beam that is one more.
  sensor.max_sector_s = 0.5 * sensor.rotation_s / static_cast<double>(state.range(0)) + 1e-4;
  run_scans(state, bench::hall_world(), sensor);
}
BENCHMARK(full_lms200_scan_by_sectors)->Arg(1)->Arg(2)->Arg(3)->Arg(6);

void full_scan_by_number_of_beams(benchmark::State& state) {
  SensorOptions sensor = sensor_preset("sick_lms200");
  sensor.interlace = false;
  sensor.step_rad = kPi / static_cast<double>(state.range(0) - 1);
  run_scans(state, bench::hall_world(), sensor);
}
BENCHMARK(full_scan_by_number_of_beams)->Arg(181)->Arg(361)->Arg(722)->Arg(1444)->Arg(3610)->Arg(14440);

// Box2D steps 60 times for each scan.
void simulated_scan_with_a_towed_cylinder(benchmark::State& state) {
  World world = bench::hall_world();
  world.walkers[0].path = {{{-3.0, 2.0}, {3.0, 2.0}, {3.0, 3.0}, {-3.0, 3.0}}, true, 0.4, false};
  world.walkers[0].tow = Tow{};
  world.walkers[0].tow->id = "cylinder";
  run_scans(state, world, sensor_preset("sick_lms200"));
}
BENCHMARK(simulated_scan_with_a_towed_cylinder);

}  // namespace
}  // namespace scanbed::sim

BENCHMARK_MAIN();
