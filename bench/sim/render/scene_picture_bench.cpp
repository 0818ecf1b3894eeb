// SPDX-License-Identifier: MIT
// What a picture of 640 x 480 costs once the scene is built, and what building it costs. Software rendering
// on all cores: the time of all threads stands beside.
#include "sim/render/scene_picture.hpp"

#include <benchmark/benchmark.h>

#include "bench/support/hall_world.hpp"
#include "core/detect/feature_detector.hpp"
#include "core/detect/presets.hpp"
#include "sim/sensor/sensor_presets.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::sim {
namespace {

PictureOptions picture_of(View view) {
  return {.width_px = 640, .height_px = 480, .view = view};
}

void picture_of_the_hall(benchmark::State& state) {
  SimulatedLms lms(bench::hall_world(), {.lms = sensor_preset("sick_lms200")});
  LaserScan scan;
  lms.next(scan, RangeSensor::Seconds(0.0));
  FeatureDetector detector(robust_options());
  const Features& features = detector.detect(scan);
  ScenePainter painter(lms.world(), picture_of(static_cast<View>(state.range(0))));
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(painter.paint(lms.state(), {scan, features, lms.truth()}, "hall").rgb.data());
  }
}
BENCHMARK(picture_of_the_hall)
    ->ArgName("view")
    ->Arg(static_cast<int>(View::kTop))
    ->Arg(static_cast<int>(View::kCamera))
    ->Arg(static_cast<int>(View::kLaser))
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void scene_of_the_hall(benchmark::State& state) {
  const World world = bench::hall_world();
  while (state.KeepRunning()) {
    ScenePainter painter(world, picture_of(View::kCamera));
    benchmark::DoNotOptimize(&painter);
  }
}
BENCHMARK(scene_of_the_hall)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scanbed::sim
BENCHMARK_MAIN();
