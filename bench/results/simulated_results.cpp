// SPDX-License-Identifier: MIT
#include "bench/results/simulated_results.hpp"

#include <algorithm>
#include <cmath>

#include "core/detect/feature_detector.hpp"
#include "core/score/match_lines.hpp"
#include "core/score/match_round.hpp"
#include "core/score/visibility.hpp"
#include "sim/sensor/sensor_presets.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::bench {
namespace {

constexpr double kMinCutShare = 0.4;
constexpr double kMaxCutShare = 0.9;
constexpr int kMinCutBeams = 8;

sim::SimulationOptions simulation_of(const SimulatedSet& set, int seed) {
  sim::SimulationOptions options{.lms = sim::sensor_preset("sick_lms200")};
  options.lms.noise_sigma_m = set.sigma_m;
  options.lms.effects.bias = 0.0;
  options.duration_s = (set.scans_a_run - 0.5) * options.lms.scan_period_s;
  options.seed = static_cast<std::uint64_t>(seed);
  return options;
}

int num_beams_on(const Truth& truth, const LaserScan& scan, int object) {
  int num_beams = 0;
  for (int i = 0; i < scan.num_beams(); ++i) {
    if (truth.beams[i].object == object && scan.has_echo(i)) ++num_beams;
  }
  return num_beams;
}

// Columns cut by others become the truth, and what is in full view neither hit nor miss.
void ask_for_cut_columns(Truth& truth, const LaserScan& scan) {
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    ObjectTruth& object = truth.objects[k];
    if (object.primitive != Primitive::kCircle || object.visibility == Visibility::kHidden) continue;
    const int in_front = num_unobstructed_beams(object.center_m, object.radius_m, scan.geometry);
    const double share = static_cast<double>(num_beams_on(truth, scan, static_cast<int>(k))) / in_front;
    const bool is_cut =
        share >= kMinCutShare && share < kMaxCutShare && object.num_clean_beams >= kMinCutBeams;
    object.visibility = is_cut ? Visibility::kResolvable : Visibility::kMarginal;
  }
}

void add(const Tally& tally, Share& precision, Share& recall) {
  precision.part += tally.num_right;
  precision.whole += tally.num_detections;
  recall.part += tally.num_found;
  recall.whole += tally.num_truths;
}

// Distance of each circle to the nearest column that must be found, where one is within the gate.
void add_center_errors(const Features& features, const Truth& truth, std::vector<double>& errors_m) {
  for (const ObjectTruth& object : truth.objects) {
    if (object.primitive != Primitive::kCircle || object.visibility != Visibility::kResolvable) continue;
    double nearest_m = MatchOptions{}.circle_center_m;
    bool found = false;
    for (const Circle& circle : features.circles) {
      const double distance_m = (circle.center_m - object.center_m).norm();
      if (distance_m > nearest_m) continue;
      nearest_m = distance_m;
      found = true;
    }
    if (found) errors_m.push_back(nearest_m);
  }
}

// Each leg by itself; those that are neither right nor wrong are left out.
void add_scores(const std::vector<Leg>& legs, const Truth& truth, ScoreBins& bins) {
  for (const Leg& leg : legs) {
    const Tally tally = match_legs({leg}, truth, MatchOptions{}).tally;
    if (tally.num_detections > 0) bins.add(leg.score, tally.num_right > 0);
  }
}

class Counter {
 public:
  Counter(const SimulatedSet& set, SimulatedResult& result) : set_(set), result_(result) {}

  void begin_run() {
    for (KindRuns* runs : {&result_.circle, &result_.line, &result_.leg}) {
      runs->precision.emplace_back();
      runs->recall.emplace_back();
    }
  }

  void count(const Features& features, const LaserScan& scan, Truth truth) {
    if (set_.worlds == WorldSet::kCut) ask_for_cut_columns(truth, scan);
    const MatchOptions options;
    const Tally circle = match_circles(features.circles, truth, options).tally;
    const Tally line = match_lines(features.lines, scan, truth, options).tally;
    const Tally leg = match_legs(features.legs, truth, options).tally;
    add(circle, result_.circle.precision.back(), result_.circle.recall.back());
    add(line, result_.line.precision.back(), result_.line.recall.back());
    add(leg, result_.leg.precision.back(), result_.leg.recall.back());
    add_scores(features.legs, truth, result_.leg_scores);
    result_.num_false_circles += circle.num_detections - circle.num_right;
    result_.num_false_legs += leg.num_detections - leg.num_right;
    add_center_errors(features, truth, result_.center_errors_m);
    ++result_.num_scans;
  }

 private:
  const SimulatedSet& set_;
  SimulatedResult& result_;
};

}  // namespace

SimulatedResult simulated_results(const SimulatedSet& set, const DetectorOptions& options) {
  SimulatedResult result;
  Counter counter(set, result);
  FeatureDetector detector(options);
  for (int seed = set.first_seed; seed < set.first_seed + set.num_runs; ++seed) {
    sim::SimulatedLms laser(result_world(set.worlds, static_cast<std::uint64_t>(seed)),
                            simulation_of(set, seed));
    counter.begin_run();
    LaserScan scan;
    while (laser.next(scan, RangeSensor::Seconds(0.0)))
      counter.count(detector.detect(scan), scan, *laser.truth());
  }
  return result;
}

}  // namespace scanbed::bench
