// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_samples.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/results/labels.hpp"
#include "bench/results/recorded_scans.hpp"
#include "bench/train_legs/leg_worlds.hpp"
#include "core/detect/feature_detector.hpp"
#include "core/geometry/angles.hpp"
#include "sim/generate/random_world.hpp"
#include "sim/generate/world_dice.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::bench {
namespace {

constexpr double kMaxLostShare = 0.03;  // of all echoes
constexpr double kLaserHeight_m = 0.28;
constexpr double kTurningShare = 0.3;
constexpr double kMaxTurn_rad_per_s = 2.2;
constexpr double kBetweenScans_s = 2.0;  // a walker's legs stand otherwise then
constexpr double kNoRehearsal_s = 0.0;   // people in each other are few, and rehearsals take long

using Judge = std::function<LegAnswer(const LegSample&)>;

DetectorOptions without_legs(DetectorOptions options) {
  options.leg.enabled = false;
  return options;
}

/// Runs candidates and features as the detector does.
class Sampler {
 public:
  void sample(const LaserScan& scan, int number, const Judge& judge, const LegSampleSink& use) {
    reader_.read(scan, beams_);
    finder_.find(beams_, candidates_);
    feature_reader_.read(beams_, candidates_, surface_detector_.detect(scan), table_);
    for (std::size_t c = 0; c < candidates_.runs.size(); ++c) {
      const EchoRun& run = candidates_.runs[c];
      LegSample sample;
      sample.scan = number;
      sample.beams = {beams_.beam[run.first], beams_.beam[run.last]};
      sample.center_m = centroid_m(beams_, run);
      for (int f = 0; f < kNumLegFeatures; ++f) sample.features[f] = table_.at(f, static_cast<int>(c));
      sample.answer = judge(sample);
      use(sample);
    }
  }

 private:
  LegBeamReader reader_;
  LegBeams beams_;
  LegCandidateFinder finder_;
  LegCandidates candidates_;
  LegFeatureReader feature_reader_;
  LegFeatureTable table_;
  FeatureDetector surface_detector_{without_legs(robust_options())};
};

struct TruthJudge {
  const LaserScan& scan;
  const Truth& truth;

  LegAnswer operator()(const LegSample& sample) const { return answer_by_truth(sample, scan, truth); }
};

// In some worlds the robot turns, and the odd beams are measured one rotation later: what stands is sheared.
void turn_robot(std::uint64_t seed, sim::World& world, sim::SensorOptions& sensor) {
  sim::WorldDice dice(seed, "turning");
  if (!dice.chance(kTurningShare)) return;
  world.robot.turn_rad_per_s = dice.uniform(0.3, kMaxTurn_rad_per_s);
  world.robot.drive = {sim::Turn{dice.chance(0.5) ? 100.0 : -100.0}};
  sensor.interlace = std::abs(sensor.step_rad - radians(0.5)) < 1e-9;
}

void lose_echoes(std::uint64_t seed, LaserScan& scan) {
  sim::WorldDice dice(seed, "lost echoes");
  const double lost_share = dice.uniform(0.0, kMaxLostShare);
  for (double& range_m : scan.range_m) {
    if (dice.chance(lost_share)) range_m = kNoEcho;
  }
}

}  // namespace

void sample_labelled(const std::filesystem::path& log, const std::filesystem::path& labels,
                     const LegSampleSink& use) {
  const Labels legs = read_leg_labels(labels, 1);
  const std::vector<Eigen::Vector2d> none;
  Sampler sampler;
  for_each_scan(log, [&](const LaserScan& scan) {
    const auto number = static_cast<int>(scan.index);
    const auto found = legs.find(number);
    const std::vector<Eigen::Vector2d>& here = found == legs.end() ? none : found->second;
    sampler.sample(
        scan, number, [&](const LegSample& sample) { return answer_by_labels(sample, here); }, use);
  });
}

void sample_empty(const std::filesystem::path& log, const LegSampleSink& use) {
  Sampler sampler;
  for_each_scan(log, [&](const LaserScan& scan) {
    sampler.sample(
        scan, static_cast<int>(scan.index), [](const LegSample&) { return LegAnswer::kNo; }, use);
  });
}

void sample_simulated(std::uint64_t first_seed, int num_worlds, const LegSampleSink& use) {
  Sampler sampler;
  LaserScan scan;
  for (std::uint64_t seed = first_seed; seed < first_seed + num_worlds; ++seed) {
    sim::SimulationOptions options{.lms = leg_sensor(seed)};
    options.duration_s = 0.5 * options.lms.scan_period_s;
    options.seed = seed;
    sim::SimulatedLms laser(leg_world(seed), options);
    if (!laser.next(scan, RangeSensor::Seconds(0.0))) continue;
    lose_echoes(seed, scan);
    sampler.sample(scan, static_cast<int>(seed), TruthJudge{scan, *laser.truth()}, use);
  }
}

void sample_random_worlds(std::uint64_t first_seed, int num_worlds, const LegSampleSink& use) {
  Sampler sampler;
  LaserScan scan;
  for (std::uint64_t seed = first_seed; seed < first_seed + num_worlds; ++seed) {
    sim::SimulationOptions options{.lms = leg_sensor(seed)};
    options.lms.scan_period_s = kBetweenScans_s;
    options.duration_s = 1.5 * kBetweenScans_s;
    options.seed = seed;
    const sim::WorldKind kind = seed % 3 == 0 ? sim::WorldKind::kCorridors : sim::WorldKind::kRooms;
    sim::World world = sim::random_world(kind, seed, kLaserHeight_m, kNoRehearsal_s);
    turn_robot(seed, world, options.lms);
    sim::SimulatedLms laser(std::move(world), options);
    while (laser.next(scan, RangeSensor::Seconds(0.0))) {
      lose_echoes(seed, scan);
      const int number = static_cast<int>(2 * seed + scan.index % 2);
      sampler.sample(scan, number, TruthJudge{scan, *laser.truth()}, use);
    }
  }
}

}  // namespace scanbed::bench
