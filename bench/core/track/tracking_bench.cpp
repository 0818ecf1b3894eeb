// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "bench/support/bench_scans.hpp"
#include "core/detect/feature_detector.hpp"
#include "core/interpret/interpreter.hpp"
#include "core/track/tracker.hpp"

namespace scanbed {
namespace {

/// Scans of one recording with their features, so that detection is not measured here.
struct Detected {
  std::vector<LaserScan> scans;
  std::vector<Features> features;

  explicit Detected(const std::vector<LaserScan>& recorded) : scans(recorded) {
    FeatureDetector detector(robust_options());
    for (const LaserScan& scan : scans) features.push_back(detector.detect(scan));
  }
};

// One iteration takes one scan; the recording begins anew when it is over, as on a clock that goes on.
void tracks_and_scene(benchmark::State& state, const std::vector<LaserScan>& recorded) {
  Detected detected(recorded);
  Tracker tracker;
  Interpreter interpreter;
  std::size_t i = 0;
  double time_s = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    LaserScan& scan = detected.scans[i];
    scan.time_s = time_s;
    const std::vector<Track>& tracks = tracker.update(scan, detected.features[i], Pose2{});
    benchmark::DoNotOptimize(&interpreter.interpret(scan, detected.features[i], tracks));
    time_s += 0.1;
    if (++i == detected.scans.size()) i = 0;
  }
  state.SetItemsProcessed(state.iterations());
}

void scan_matching(benchmark::State& state, const std::vector<LaserScan>& recorded) {
  EgoMotion ego;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(&ego.update(recorded[i]));
    if (++i == recorded.size()) i = 0;
  }
  state.SetItemsProcessed(state.iterations());
}

}  // namespace
}  // namespace scanbed

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const std::vector<scanbed::bench::BenchScans> sets = scanbed::bench::bench_scans();
  for (const scanbed::bench::BenchScans& set : sets) {
    benchmark::RegisterBenchmark(("tracks_and_scene/" + set.name).c_str(), [&set](benchmark::State& state) {
      scanbed::tracks_and_scene(state, set.scans);
    });
    benchmark::RegisterBenchmark(("scan_matching/" + set.name).c_str(), [&set](benchmark::State& state) {
      scanbed::scan_matching(state, set.scans);
    });
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
