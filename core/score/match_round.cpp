// SPDX-License-Identifier: MIT
#include "core/score/match_round.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

namespace scanbed {
namespace {

// A detection stripped to what matching needs.
struct Candidate {
  BeamSpan beams;
  Eigen::Vector2d center_m;
  double radius_m = 0.0;
};

struct Pair {
  double distance_m;
  int detection;
  int object;

  bool operator<(const Pair& other) const {  // nearest first; indices settle ties
    return std::tie(distance_m, detection, object) <
           std::tie(other.distance_m, other.detection, other.object);
  }
};

using Gate = std::function<bool(const Candidate&, const ObjectTruth&)>;

// Of each detection the object it matched, or kNoObject.
std::vector<int> match_nearest_first(const std::vector<Candidate>& detections, const Truth& truth,
                                     const Gate& gate) {
  std::vector<Pair> pairs;
  for (std::size_t d = 0; d < detections.size(); ++d) {
    for (std::size_t k = 0; k < truth.objects.size(); ++k) {
      const ObjectTruth& object = truth.objects[k];
      if (object.visibility == Visibility::kHidden || !gate(detections[d], object)) continue;
      const double distance_m = (detections[d].center_m - object.center_m).norm();
      pairs.push_back({distance_m, static_cast<int>(d), static_cast<int>(k)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<int> object_of(detections.size(), kNoObject);
  std::vector<bool> taken(truth.objects.size(), false);
  for (const Pair& pair : pairs) {
    if (object_of[pair.detection] != kNoObject || taken[pair.object]) continue;
    object_of[pair.detection] = pair.object;
    taken[pair.object] = true;
  }
  return object_of;
}

// Whether more than half of the detection's beams met objects that excuse it.
bool mostly_on(const BeamSpan& beams, const Truth& truth,
               const std::function<bool(const ObjectTruth&)>& excuses) {
  int num_excused = 0;
  for (int i = beams.first; i <= beams.last; ++i) {
    const int object = truth.beams[i].object;
    if (object != kNoObject && excuses(truth.objects[object])) ++num_excused;
  }
  return 2 * num_excused > beams.last - beams.first + 1;
}

struct Rules {
  Primitive primitive;
  Gate gate;
  std::function<bool(const ObjectTruth&)> excuses;  // objects on which an unmatched detection is no error
};

KindScore match(const std::vector<Candidate>& detections, const Truth& truth, const Rules& rules) {
  KindScore score;
  const std::vector<int> object_of = match_nearest_first(detections, truth, rules.gate);
  std::vector<bool> found(truth.objects.size(), false);
  for (std::size_t d = 0; d < detections.size(); ++d) {
    const int k = object_of[d];
    const bool right = k != kNoObject && truth.objects[k].visibility == Visibility::kResolvable;
    if (right) {
      found[k] = true;
      ++score.tally.num_right;
      score.tally.sum_squared_error_m2 += (detections[d].center_m - truth.objects[k].center_m).squaredNorm();
    }
    const bool neither = !right && (k != kNoObject || mostly_on(detections[d].beams, truth, rules.excuses));
    ++(neither ? score.tally.num_neither : score.tally.num_detections);
  }
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    const ObjectTruth& object = truth.objects[k];
    if (object.primitive != rules.primitive || object.visibility != Visibility::kResolvable) continue;
    score.count_truth(object.center_m.norm(), found[k]);
  }
  return score;
}

}  // namespace

KindScore match_circles(const std::vector<Circle>& circles, const Truth& truth, const MatchOptions& options) {
  std::vector<Candidate> candidates;
  candidates.reserve(circles.size());
  for (const Circle& circle : circles) candidates.push_back({circle.beams, circle.center_m, circle.radius_m});
  const Gate gate = [&](const Candidate& c, const ObjectTruth& object) {
    return object.primitive == Primitive::kCircle &&
           (c.center_m - object.center_m).norm() <= options.circle_center_m &&
           std::abs(c.radius_m - object.radius_m) <= options.circle_radius_m;
  };
  const auto excuses = [](const ObjectTruth& object) {
    return object.primitive == Primitive::kLeg ||
           (object.primitive == Primitive::kCircle && object.visibility != Visibility::kResolvable);
  };
  return match(candidates, truth, {Primitive::kCircle, gate, excuses});
}

KindScore match_legs(const std::vector<Leg>& legs, const Truth& truth, const MatchOptions& options) {
  std::vector<Candidate> candidates;
  candidates.reserve(legs.size());
  for (const Leg& leg : legs) candidates.push_back({leg.beams, leg.middle_m, 0.0});
  const Gate gate = [&](const Candidate& c, const ObjectTruth& object) {
    return object.primitive == Primitive::kLeg &&
           (c.center_m - object.center_m).norm() <= options.leg_center_m;
  };
  const auto excuses = [&](const ObjectTruth& object) {
    return (object.primitive == Primitive::kCircle && object.radius_m < options.narrow_cylinder_m) ||
           (object.primitive == Primitive::kLeg && object.visibility != Visibility::kResolvable);
  };
  return match(candidates, truth, {Primitive::kLeg, gate, excuses});
}

}  // namespace scanbed
