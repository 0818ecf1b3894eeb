// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "bench/results/labels.hpp"
#include "bench/train_legs/leg_worlds.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/pose2.hpp"
#include "hw/recording/carmen_log.hpp"
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
constexpr double kMaxPostShare = 0.3;
constexpr double kMaxLostShare = 0.03;

// Of what belongs to a cut-out person, from its labels.
constexpr double kCutOutGate_m = 0.22;
constexpr double kMaxStride_m = 0.7;
constexpr double kMinRoom_m = 0.15;
constexpr double kMaxRoom_m = 0.9;
constexpr int kPasteTrials = 20;

using Judge = std::function<LegAnswer(const LegSample&)>;

/// Runs candidates and features as the detector does.
class Sampler {
 public:
  void sample(const LaserScan& scan, int number, const Judge& judge, const LegSampleSink& use) {
    reader_.read(scan, beams_);
    finder_.find(beams_, candidates_);
    feature_reader_.read(beams_, candidates_, table_);
    for (std::size_t c = 0; c < candidates_.runs.size(); ++c) {
      const EchoRun& run = candidates_.runs[c];
      LegSample sample;
      sample.scan = number;
      sample.beams = {beams_.beam[run.first], beams_.beam[run.last]};
      sample.center_m = centroid_m(beams_, run);
      for (int f = 0; f < kNumLegFeatures; ++f) sample.features[f] = table_.row(f)[c];
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
};

void for_each_scan(const std::filesystem::path& log, const std::function<void(const LaserScan&)>& use) {
  hw::CarmenLog sensor(log, {},
                       [](const std::string& message) { std::fprintf(stderr, "%s\n", message.c_str()); });
  LaserScan scan;
  while (sensor.next(scan, RangeSensor::Seconds(0.0))) use(scan);
}

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

// The leg that a beam met: "leg12" and, of its outline's third edge, "leg12.2" are one.
std::string leg_of(const Truth& truth, int beam) {
  const int object = truth.beams[beam].object;
  if (object == kNoObject || truth.objects[object].label != "leg") return {};
  const std::string& id = truth.objects[object].id;
  return id.substr(0, id.find('.'));
}

LegAnswer by_truth(const LegSample& sample, const LaserScan& scan, const Truth& truth) {
  int num_echoes = 0;
  int num_on_posts = 0;
  std::map<std::string, int> num_on_leg;
  for (int i = sample.beams.first; i <= sample.beams.last; ++i) {
    if (!scan.has_echo(i)) continue;
    ++num_echoes;
    const int object = truth.beams[i].object;
    if (object != kNoObject && truth.objects[object].label == "post") ++num_on_posts;
    const std::string leg = leg_of(truth, i);
    if (!leg.empty()) ++num_on_leg[leg];
  }
  int num_on_legs = 0;
  std::pair<std::string, int> most{"", 0};
  for (const auto& leg : num_on_leg) {
    num_on_legs += leg.second;
    if (leg.second > most.second) most = leg;
  }
  int num_of_leg = 0;
  for (int i = 0; i < scan.num_beams(); ++i) {
    if (scan.has_echo(i) && leg_of(truth, i) == most.first) ++num_of_leg;
  }
  if (num_on_legs > 0 && most.second >= kMinOwnShare * num_echoes &&
      most.second >= kMinCoveredShare * num_of_leg) {
    return LegAnswer::kYes;
  }
  const bool is_none = num_on_legs < kMaxLegShare * num_echoes && num_on_posts < kMaxPostShare * num_echoes;
  return is_none ? LegAnswer::kNo : LegAnswer::kUnknown;
}

// All that is no leg is in the backgrounds already.
LegAnswer by_pasted(const LegSample& sample, const std::vector<Eigen::Vector2d>& places) {
  const bool is_leg = std::any_of(places.begin(), places.end(), [&](const Eigen::Vector2d& place) {
    return (place - sample.center_m).norm() <= kLegGate_m;
  });
  return is_leg ? LegAnswer::kYes : LegAnswer::kUnknown;
}

/// The echoes around the labels of one person, and those labels.
struct CutOut {
  std::vector<int> beam;
  std::vector<double> range_m;
  std::vector<Eigen::Vector2d> labels_m;
};

Eigen::Vector2d point_m(const LaserScan& scan, int beam, double range_m) {
  const double bearing_rad = scan.geometry.bearing_rad(beam);
  return range_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
}

// Labels that a stride can join are a person's.
std::vector<CutOut> cut_out(const LaserScan& scan, std::vector<Eigen::Vector2d> labels) {
  std::vector<CutOut> people;
  while (!labels.empty()) {
    CutOut person;
    person.labels_m.push_back(labels.back());
    labels.pop_back();
    for (auto it = labels.begin(); it != labels.end();) {
      const bool joins = (*it - person.labels_m.front()).norm() < kMaxStride_m;
      if (joins) person.labels_m.push_back(*it);
      it = joins ? labels.erase(it) : it + 1;
    }
    for (int i = 0; i < scan.num_beams(); ++i) {
      if (!scan.has_echo(i)) continue;
      const Eigen::Vector2d p_m = point_m(scan, i, scan.range_m[i]);
      const bool is_own =
          std::any_of(person.labels_m.begin(), person.labels_m.end(),
                      [&](const Eigen::Vector2d& label) { return (label - p_m).norm() < kCutOutGate_m; });
      if (!is_own) continue;
      person.beam.push_back(i);
      person.range_m.push_back(scan.range_m[i]);
    }
    if (person.beam.size() >= 3) people.push_back(std::move(person));
  }
  return people;
}

// Puts a person into the scan, turned by so many beams, unless something hides it or stands too near.
bool paste(const CutOut& person, int turn, double room_m, LaserScan& scan) {
  for (std::size_t k = 0; k < person.beam.size(); ++k) {
    const int beam = person.beam[k] + turn;
    if (beam < 0 || beam >= scan.num_beams() || !(scan.range_m[beam] > person.range_m[k])) return false;
    const Eigen::Vector2d p_m = point_m(scan, beam, person.range_m[k]);
    for (int i = 0; i < scan.num_beams(); ++i) {
      if (scan.has_echo(i) && (point_m(scan, i, scan.range_m[i]) - p_m).norm() < room_m) return false;
    }
  }
  for (std::size_t k = 0; k < person.beam.size(); ++k)
    scan.range_m[person.beam[k] + turn] = person.range_m[k];
  return true;
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

std::vector<LaserScan> scans_of(const std::filesystem::path& log) {
  std::vector<LaserScan> scans;
  for_each_scan(log, [&](const LaserScan& scan) { scans.push_back(scan); });
  return scans;
}

std::vector<LaserScan> simulated_backgrounds(std::uint64_t first_seed, int num_worlds) {
  std::vector<LaserScan> scans;
  LaserScan scan;
  for (std::uint64_t seed = first_seed; seed < first_seed + num_worlds; ++seed) {
    sim::SimulationOptions options{.lms = leg_sensor(seed)};
    options.lms.step_rad = radians(0.5);
    options.lms.fov_rad = radians(180.0);
    options.duration_s = 0.5 * options.lms.scan_period_s;
    options.seed = seed;
    sim::World world = leg_world(seed);
    std::erase_if(world.solids,
                  [](const sim::Solid& solid) { return solid.label == "leg" || solid.label == "post"; });
    if (sim::SimulatedLms laser(world, options); laser.next(scan, RangeSensor::Seconds(0.0)))
      scans.push_back(scan);
  }
  return scans;
}

void sample_pasted(const std::filesystem::path& log, const std::filesystem::path& labels,
                   const std::vector<LaserScan>& backgrounds, int copies, const LegSampleSink& use) {
  const Labels legs = read_leg_labels(labels, 3);
  sim::WorldDice dice(1, "paste");
  Sampler sampler;
  for_each_scan(log, [&](const LaserScan& scan) {
    const auto found = legs.find(static_cast<int>(scan.index));
    if (found == legs.end()) return;
    for (const CutOut& person : cut_out(scan, found->second)) {
      for (int copy = 0; copy < copies; ++copy) {
        for (int trial = 0; trial < kPasteTrials; ++trial) {
          LaserScan made = backgrounds[dice.whole(0, static_cast<int>(backgrounds.size()) - 1)];
          const int turn = dice.whole(-person.beam.front(), made.num_beams() - 1 - person.beam.back());
          if (!paste(person, turn, dice.uniform(kMinRoom_m, kMaxRoom_m), made)) continue;
          const Pose2 rotation{Eigen::Vector2d::Zero(), turn * made.geometry.step_rad};
          std::vector<Eigen::Vector2d> places;
          for (const Eigen::Vector2d& label : person.labels_m) places.push_back(rotation * label);
          sampler.sample(
              made, static_cast<int>(scan.index), [&](const LegSample& s) { return by_pasted(s, places); },
              use);
          break;
        }
      }
    }
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
    sim::WorldDice dice(seed, "lost echoes");
    const double lost_share = dice.uniform(0.0, kMaxLostShare);
    for (double& range_m : scan.range_m) {
      if (dice.chance(lost_share)) range_m = kNoEcho;
    }
    const Truth& truth = *laser.truth();
    sampler.sample(
        scan, static_cast<int>(seed), [&](const LegSample& sample) { return by_truth(sample, scan, truth); },
        use);
  }
}

}  // namespace scanbed::bench
