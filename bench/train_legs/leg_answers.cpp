// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_answers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/geometry/angles.hpp"
#include "core/score/match_options.hpp"
#include "core/score/visibility.hpp"

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
constexpr double kMinPostRadius_m = 0.035;

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

// Of a candidate, and those of them on posts that might be legs.
struct Echoes {
  int num = 0;
  int num_on_posts = 0;
};

Echoes echoes_of(const LegSample& sample, const LaserScan& scan, const Truth& truth) {
  Echoes echoes;
  for (int i = sample.beams.first; i <= sample.beams.last; ++i) {
    if (!scan.has_echo(i)) continue;
    ++echoes.num;
    const int object = truth.beams[i].object;
    if (object != kNoObject && might_be_leg(truth.objects[object])) ++echoes.num_on_posts;
  }
  return echoes;
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

}  // namespace

LegAnswer answer_by_labels(const LegSample& sample, const std::vector<Eigen::Vector2d>& labels) {
  double nearest_m = kNoLegGate_m + 1.0;
  for (const Eigen::Vector2d& label : labels)
    nearest_m = std::min(nearest_m, (label - sample.center_m).norm());
  if (nearest_m <= kLegGate_m) return LegAnswer::kYes;
  const double bearing_rad = std::atan2(sample.center_m.y(), sample.center_m.x());
  const bool is_labelled_place =
      std::abs(bearing_rad) < kLabelledSector_rad && sample.center_m.norm() < kLabelledRange_m;
  return is_labelled_place && nearest_m > kNoLegGate_m ? LegAnswer::kNo : LegAnswer::kUnknown;
}

LegAnswer answer_by_truth(const LegSample& sample, const LaserScan& scan, const Truth& truth) {
  const auto [num_echoes, num_on_posts] = echoes_of(sample, scan, truth);
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

}  // namespace scanbed::bench
