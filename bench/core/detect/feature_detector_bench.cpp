// SPDX-License-Identifier: MIT
#include "core/detect/feature_detector.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <vector>

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

DetectorOptions options_for(const Parts& parts, DetectorOptions options = paper_options()) {
  if (!parts.lines) options.line.method = LineMethod::kOff;
  if (!parts.circles) options.circle.method = CircleMethod::kOff;
  options.leg.enabled = parts.legs;
  options.circle.prerequisite = parts.prerequisite;
  return options;
}

// Calls `run` and keeps how long it took.
template <typename Run>
void time_one(std::vector<double>& times_us, const Run& run) {
  const auto begin = std::chrono::steady_clock::now();
  run();
  times_us.push_back(
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
}

double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// One iteration detects in one scan; scans take turns.
void detect_in_turn(benchmark::State& state, const std::vector<LaserScan>& scans,
                    const DetectorOptions& options) {
  FeatureDetector detector(options);
  std::size_t i = 0;
  std::vector<double> times_us;
  for ([[maybe_unused]] auto _ : state) {
    time_one(times_us, [&] { benchmark::DoNotOptimize(&detector.detect(scans[i])); });
    if (++i == scans.size()) i = 0;
  }
  state.counters["median_us"] = quantile(times_us, 0.5);
  state.counters["p99_us"] = quantile(times_us, 0.99);
  state.SetItemsProcessed(state.iterations());
}

Eigen::Vector2d at(double bearing_rad, double range_m) {
  return range_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
}

/// Straight walls around the sensor that meet at the given number of corners, alternately near and far, seen
/// by always the same beams: what makes line time oscillate in the paper's fig. 8.
LaserScan zigzag(int num_corners) {
  LaserScan scan;
  const ScanGeometry& geometry = scan.geometry;
  const double wall_rad = (geometry.num_beams - 1) * geometry.step_rad / (num_corners + 1);
  for (int i = 0; i < geometry.num_beams; ++i) {
    const int wall = std::min(num_corners, static_cast<int>(i * geometry.step_rad / wall_rad));
    const auto corner = [&](int k) { return at(geometry.first_rad + k * wall_rad, k % 2 == 0 ? 2.0 : 2.6); };
    const Eigen::Vector2d a_m = corner(wall);
    const Eigen::Vector2d along_m = corner(wall + 1) - a_m;
    const Eigen::Vector2d u = at(geometry.bearing_rad(i), 1.0);
    scan.range_m.push_back((a_m.x() * along_m.y() - a_m.y() * along_m.x()) /
                           (u.x() * along_m.y() - u.y() * along_m.x()));
  }
  return scan;
}

void lines_by_number_of_corners(benchmark::State& state) {
  DetectorOptions options = options_for({.name = "lines", .lines = true});
  options.line.max_error_m = 0.02;
  options.segmentation.max_gap_m = 0.5;
  FeatureDetector detector(options);
  const LaserScan scan = zigzag(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(&detector.detect(scan));
  state.counters["lines"] = static_cast<double>(detector.detect(scan).lines.size());
}
BENCHMARK(lines_by_number_of_corners)->RangeMultiplier(2)->Range(2, 32);

void robust_by_number_of_beams(benchmark::State& state, bool legs) {
  const Parts parts{.name = "by_number_of_beams", .lines = true, .circles = true, .legs = legs};
  const auto num_beams = static_cast<int>(state.range(0));
  detect_in_turn(state, bench::hall_scans(num_beams), options_for(parts, robust_options()));
  state.counters["beams"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * num_beams, benchmark::Counter::kIsRate);
}
constexpr std::initializer_list<std::int64_t> kNumBeams = {181, 361, 721, 1081, 1441, 2881, 5761};
BENCHMARK_CAPTURE(robust_by_number_of_beams, shapes, false)->ArgsProduct({kNumBeams});
BENCHMARK_CAPTURE(robust_by_number_of_beams, all, true)->ArgsProduct({kNumBeams});

void register_recorded(const std::vector<bench::BenchScans>& sets) {
  static const Parts kParts[] = {
      {"segmentation"},
      {.name = "lines", .lines = true},
      {.name = "circles", .circles = true},
      {.name = "circles_without_prerequisite", .circles = true, .prerequisite = false},
      {.name = "legs", .legs = true},
      {.name = "all", .lines = true, .circles = true, .legs = true},
  };
  constexpr Parts kShapes{.name = "shapes", .lines = true, .circles = true};
  for (const bench::BenchScans& set : sets) {
    for (const Parts& parts : kParts) {
      const std::string name = "paper/" + std::string(parts.name) + "/" + set.name;
      benchmark::RegisterBenchmark(name.c_str(), [&set, &parts](benchmark::State& state) {
        detect_in_turn(state, set.scans, options_for(parts));
      });
    }
    for (const Parts& parts : {kParts[0], kShapes, kParts[5]}) {
      const std::string name = "robust/" + std::string(parts.name) + "/" + set.name;
      benchmark::RegisterBenchmark(name.c_str(), [&set, parts](benchmark::State& state) {
        detect_in_turn(state, set.scans, options_for(parts, robust_options()));
      });
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
