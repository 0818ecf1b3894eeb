// SPDX-License-Identifier: MIT
#include "scenarios/run/scan_condition.hpp"

#include <algorithm>
#include <vector>

#include "core/geometry/segment_distance.hpp"
#include "core/score/scorer.hpp"
#include "scenarios/run/gates.hpp"

namespace scanbed::scenarios {
namespace {

using Eigen::Vector2d;

// A point is a segment of length 0.
struct Segment {
  Vector2d from_m;
  Vector2d to_m;
};

double distance_m(const Vector2d& p_m, const Segment& segment) {
  return segment_distance_m(p_m, segment.from_m, segment.to_m);
}

// Of a point to a segment; of two segments from the middle of the one to the other, since a wall's end that
// touches another wall is not near it as a whole.
double distance_m(const Segment& feature, const Segment& object) {
  if (object.from_m == object.to_m) return distance_m(object.from_m, feature);
  return distance_m(Vector2d(0.5 * (feature.from_m + feature.to_m)), object);
}

std::vector<Segment> places(const Features& features, FeatureKind kind) {
  std::vector<Segment> places;
  switch (kind) {
    case FeatureKind::kLine:
      for (const Line& line : features.lines) places.push_back({line.left_m, line.right_m});
      break;
    case FeatureKind::kCircle:
      for (const Circle& circle : features.circles) places.push_back({circle.center_m, circle.center_m});
      break;
    case FeatureKind::kLeg:
    case FeatureKind::kPerson:
    case FeatureKind::kCylinder:
      for (const Leg& leg : features.legs) places.push_back({leg.middle_m, leg.middle_m});
      break;
  }
  return places;
}

std::vector<Segment> places(const Scene& scene, SceneKind kind) {
  const bool has_ends = kind == SceneKind::kWall || kind == SceneKind::kBench || kind == SceneKind::kDoor;
  std::vector<Segment> places;
  for (const SceneObject& object : scene.objects) {
    if (object.kind != kind) continue;
    places.push_back(has_ends ? Segment{object.left_m, object.right_m}
                              : Segment{object.center_m, object.center_m});
  }
  return places;
}

std::vector<Segment> places(const DetectedScan& detected, ExpectedKind kind) {
  if (const auto* feature = std::get_if<FeatureKind>(&kind)) return places(detected.features, *feature);
  return places(*detected.scene, std::get<SceneKind>(kind));
}

bool is_meant(const ObjectTruth& object, const std::string& id) {
  if (!object.id.starts_with(id)) return false;
  return object.id.size() == id.size() || object.id[id.size()] == '.';
}

// Truth puts what is not in the world at this moment into the sensor's own place, where nothing can be.
bool is_present(const ObjectTruth& object) {
  return object.primitive == Primitive::kLine ? object.from_m != object.to_m : !object.center_m.isZero(0.0);
}

// Empty where the world has no such object: it is another one's.
std::optional<int> num_near(const std::vector<Segment>& features, const NearObject& near,
                            const Truth& truth) {
  std::vector<Segment> objects;
  bool is_known = false;
  for (const ObjectTruth& object : truth.objects) {
    if (!is_meant(object, near.id)) continue;
    is_known = true;
    if (!is_present(object)) continue;
    const bool is_line = object.primitive == Primitive::kLine;
    objects.push_back(is_line ? Segment{object.from_m, object.to_m}
                              : Segment{object.center_m, object.center_m});
  }
  if (!is_known) return std::nullopt;
  const auto is_near = [&](const Segment& feature) {
    return std::any_of(objects.begin(), objects.end(),
                       [&](const Segment& object) { return distance_m(feature, object) <= near.within_m; });
  };
  return static_cast<int>(std::count_if(features.begin(), features.end(), is_near));
}

std::optional<bool> reaches(const ScanCondition& condition, const Tally& tally) {
  if (condition.recall && tally.num_truths == 0) return std::nullopt;
  if (condition.precision && tally.num_detections == 0) return std::nullopt;
  return (!condition.recall || tally.recall() >= *condition.recall) &&
         (!condition.precision || tally.precision() >= *condition.precision);
}

}  // namespace

std::optional<bool> holds(const ScanCondition& condition, const DetectedScan& detected,
                          const MatchOptions& match) {
  if (condition.needs_truth() && detected.truth == nullptr) return std::nullopt;
  if (condition.needs_scene() && detected.scene == nullptr) return std::nullopt;
  const std::vector<Segment> found = places(detected, condition.kind);
  std::optional<int> count = static_cast<int>(found.size());
  if (condition.near) count = num_near(found, *condition.near, *detected.truth);
  if (!count) return std::nullopt;
  const bool is_count_fine = *count >= condition.at_least && *count <= condition.at_most;
  if (!condition.recall && !condition.precision) return is_count_fine;
  Scorer scorer(match);
  scorer.add(detected.features, detected.scan, *detected.truth);
  const std::optional<bool> is_score_fine =
      reaches(condition, score_of(scorer.scores(), std::get<FeatureKind>(condition.kind)).tally);
  return is_score_fine ? std::optional(*is_score_fine && is_count_fine) : std::nullopt;
}

}  // namespace scanbed::scenarios
