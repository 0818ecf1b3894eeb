// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_samples.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "bench/results/labels.hpp"
#include "bench/results/recorded_scans.hpp"
#include "bench/train_legs/leg_worlds.hpp"
#include "core/detect/feature_detector.hpp"
#include "core/geometry/angles.hpp"
#include "core/score/match_options.hpp"
#include "core/score/visibility.hpp"
#include "sim/generate/random_world.hpp"
#include "sim/generate/world_dice.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::bench {
namespace {

constexpr double kLegGate_m = 0.10;
constexpr double kNoLegGate_m = 0.30;
// A little inside of what is labelled: a leg on its border may be left out.
constexpr double kLabelledSector_rad = radians(14.5);
constexpr double kLabelledRange_m = 4.9;

constexpr double kMinOwnShare = 0.75;
constexpr double kMinCoveredShare = 0.65;
constexpr double kMaxLegShare = 0.4;
constexpr double kMaxSliver = 0.3;   // of a leg's beams: no leg by itself
constexpr double kThinLeg_m = 0.10;  // across
constexpr double kMaxPostShare = 0.3;
constexpr double kMaxLostShare = 0.03;
constexpr double kMinPostRadius_m = 0.035;

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

LegAnswer by_labels(const LegSample& sample, const std::vector<Eigen::Vector2d>& labels) {
  double nearest_m = kNoLegGate_m + 1.0;
  for (const Eigen::Vector2d& label : labels)
    nearest_m = std::min(nearest_m, (label - sample.center_m).norm());
  if (nearest_m <= kLegGate_m) return LegAnswer::kYes;
  const double bearing_rad = std::atan2(sample.center_m.y(), sample.center_m.x());
  const bool is_labelled_place =
      std::abs(bearing_rad) < kLabelledSector_rad && sample.center_m.norm() < kLabelledRange_m;
  return is_labelled_place && nearest_m > kNoLegGate_m ? LegAnswer::kNo : LegAnswer::kUnknown;
}

// The leg that a beam met: "leg12" and, of its outline's third edge, "leg12.2" are one; a walker has two.
std::string leg_of(const Truth& truth, int beam) {
  const int object = truth.beams[beam].object;
  if (object == kNoObject || truth.objects[object].label != "leg") return {};
  const std::string& id = truth.objects[object].id;
  if (id.ends_with("_leg")) return id;
  return id.substr(0, id.find('.'));
}

// A post of a leg's size is one for all that a single scan shows.
bool might_be_leg(const ObjectTruth& object) {
  return object.primitive == Primitive::kCircle && object.radius_m > kMinPostRadius_m &&
         object.radius_m < MatchOptions{}.narrow_cylinder_m;
}

// How the beams of a candidate, and of the whole scan, lie on one leg.
struct BeamsOnLeg {
  int in_candidate = 0;
  int in_scan = 0;
};

std::map<std::string, BeamsOnLeg> beams_on_legs(const LegSample& sample, const LaserScan& scan,
                                                const Truth& truth) {
  std::map<std::string, BeamsOnLeg> legs;
  for (int i = 0; i < scan.num_beams(); ++i) {
    const std::string leg = scan.has_echo(i) ? leg_of(truth, i) : std::string();
    if (leg.empty()) continue;
    BeamsOnLeg& on = legs[leg];
    ++on.in_scan;
    if (i >= sample.beams.first && i <= sample.beams.last) ++on.in_candidate;
  }
  return legs;
}

// As the scorer has it, but for legs that are so far away that there are no more beams.
bool is_hidden(const BeamsOnLeg& leg, double spacing_m) {
  return leg.in_scan < kMinVisibleBeams && spacing_m < kThinLeg_m / (kMinVisibleBeams + 1);
}

LegAnswer by_truth(const LegSample& sample, const LaserScan& scan, const Truth& truth) {
  int num_echoes = 0;
  int num_on_posts = 0;
  for (int i = sample.beams.first; i <= sample.beams.last; ++i) {
    if (!scan.has_echo(i)) continue;
    ++num_echoes;
    const int object = truth.beams[i].object;
    if (object != kNoObject && might_be_leg(truth.objects[object])) ++num_on_posts;
  }
  const double spacing_m = sample.center_m.norm() * std::abs(scan.geometry.step_rad);
  int num_on_legs = 0;
  double most_covered = 0.0;
  for (const auto& [id, leg] : beams_on_legs(sample, scan, truth)) {
    if (is_hidden(leg, spacing_m)) continue;
    const double covered = static_cast<double>(leg.in_candidate) / leg.in_scan;
    if (leg.in_candidate >= kMinOwnShare * num_echoes && covered >= kMinCoveredShare) return LegAnswer::kYes;
    num_on_legs += leg.in_candidate;
    most_covered = std::max(most_covered, covered);
  }
  const bool is_off_legs = num_on_legs < kMaxLegShare * num_echoes || most_covered < kMaxSliver;
  return is_off_legs && num_on_posts < kMaxPostShare * num_echoes ? LegAnswer::kNo : LegAnswer::kUnknown;
}

struct TruthJudge {
  const LaserScan& scan;
  const Truth& truth;

  LegAnswer operator()(const LegSample& sample) const { return by_truth(sample, scan, truth); }
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
        scan, number, [&](const LegSample& sample) { return by_labels(sample, here); }, use);
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
