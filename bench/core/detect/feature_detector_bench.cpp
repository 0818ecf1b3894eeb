// SPDX-License-Identifier: MIT
#include "core/detect/feature_detector.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/support/bench_scans.hpp"

namespace scanbed {
namespace {

/// Which parts of the pipeline run: segmentation always does.
struct Parts {
  const char* name;
  bool lines = false;
  bool circles = false;
  bool legs = false;
  bool prerequisite = true;
};

DetectorOptions options_for(const Parts& parts) {
  DetectorOptions options = paper_options();
  if (!parts.lines) options.line.method = LineMethod::kOff;
  if (!parts.circles) options.circle.method = CircleMethod::kOff;
  options.leg.enabled = parts.legs;
  options.circle.prerequisite = parts.prerequisite;
  return options;
}

// One iteration detects in one scan; scans take turns.
void detect_in_turn(benchmark::State& state, const std::vector<LaserScan>& scans, const Parts& parts) {
  FeatureDetector detector(options_for(parts));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(&detector.detect(scans[i]));
    if (++i == scans.size()) i = 0;
  }
  state.SetItemsProcessed(state.iterations());
}

/// A wall folded into a zigzag with the given number of corners, always of the same beams: what the paper's
/// fig. 8 shows as time that oscillates with the corners in view.
LaserScan zigzag(int num_corners) {
  LaserScan scan;
  for (int i = 0; i < scan.geometry.num_beams; ++i) {
    const double phase = static_cast<double>(i) / (scan.geometry.num_beams - 1) * (num_corners + 1);
    const double tooth = std::abs(std::remainder(phase, 2.0));  // 0..1..0
    scan.range_m.push_back(2.0 + tooth * 4.0 / (num_corners + 1));
  }
  return scan;
}

void lines_by_number_of_corners(benchmark::State& state) {
  DetectorOptions options = options_for({.name = "lines", .lines = true});
  options.line.max_error_m = 0.02;
  options.segmentation.max_gap_m = 0.5;
  FeatureDetector detector(options);
  const LaserScan scan = zigzag(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(&detector.detect(scan));
  state.counters["lines"] = static_cast<double>(detector.detect(scan).lines.size());
}
BENCHMARK(lines_by_number_of_corners)->RangeMultiplier(2)->Range(1, 32);

void register_recorded(const std::vector<bench::BenchScans>& sets) {
  static const Parts kParts[] = {
      {"segmentation"},
      {.name = "lines", .lines = true},
      {.name = "circles", .circles = true},
      {.name = "circles_without_prerequisite", .circles = true, .prerequisite = false},
      {.name = "legs", .legs = true},
      {.name = "all", .lines = true, .circles = true, .legs = true},
  };
  for (const bench::BenchScans& set : sets) {
    for (const Parts& parts : kParts) {
      const std::string name = "paper/" + std::string(parts.name) + "/" + set.name;
      benchmark::RegisterBenchmark(
          name.c_str(), [&set, &parts](benchmark::State& state) { detect_in_turn(state, set.scans, parts); });
    }
  }
}

}  // namespace
}  // namespace scanbed

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const std::vector<scanbed::bench::BenchScans> sets = scanbed::bench::bench_scans();
  scanbed::register_recorded(sets);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
