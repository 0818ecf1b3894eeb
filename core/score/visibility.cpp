// SPDX-License-Identifier: MIT
#include "core/score/visibility.hpp"

#include <cmath>

#include "core/errors/ensure.hpp"

namespace scanbed {
namespace {

constexpr int kMinCircleBeams = 6;
constexpr int kMinLegBeams = 4;
constexpr double kMinFrontRatio = 0.9;

bool round_object_is_resolvable(const ObjectTruth& object, int num_beams, const ScanGeometry& geometry) {
  const int min_clean = object.primitive == Primitive::kLeg ? kMinLegBeams : kMinCircleBeams;
  if (object.num_clean_beams < min_clean) return false;
  return num_beams >= kMinFrontRatio * num_unobstructed_beams(object.center_m, object.radius_m, geometry);
}

Visibility visibility_of(const ObjectTruth& object, int num_beams, const ScanGeometry& geometry) {
  if (num_beams < kMinVisibleBeams) return Visibility::kHidden;
  const bool is_round = object.primitive == Primitive::kCircle || object.primitive == Primitive::kLeg;
  return is_round && round_object_is_resolvable(object, num_beams, geometry) ? Visibility::kResolvable
                                                                             : Visibility::kMarginal;
}

}  // namespace

int num_unobstructed_beams(const Eigen::Vector2d& p_SC, double radius_m, const ScanGeometry& geometry) {
  const double step_rad = std::abs(geometry.step_rad);
  const double distance_m = p_SC.norm();
  if (distance_m <= radius_m) return static_cast<int>(std::lround(2.0 * kPi / step_rad));
  const double bearing_rad = std::atan2(p_SC.y(), p_SC.x());
  const double half_width_rad = std::asin(radius_m / distance_m);
  // Beams stand on a grid that goes on beyond the field of view; count its lines between the two tangents.
  const double first = std::ceil((bearing_rad - half_width_rad - geometry.first_rad) / step_rad);
  const double last = std::floor((bearing_rad + half_width_rad - geometry.first_rad) / step_rad);
  return static_cast<int>(last - first) + 1;
}

// All into the counts, the clean ones into the objects.
void VisibilityClassifier::count_beams(Truth& truth, const LaserScan& scan) {
  num_beams_.assign(truth.objects.size(), 0);
  for (ObjectTruth& object : truth.objects) object.num_clean_beams = 0;
  for (int i = 0; i < scan.num_beams(); ++i) {
    const BeamTruth& beam = truth.beams[i];
    if (beam.object == kNoObject || !scan.has_echo(i)) continue;
    ++num_beams_[beam.object];
    if (!beam.mixed) ++truth.objects[beam.object].num_clean_beams;
  }
}

void VisibilityClassifier::classify(Truth& truth, const LaserScan& scan) {
  SCANBED_ENSURE(truth.beams.size() == scan.range_m.size());
  count_beams(truth, scan);
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    truth.objects[k].visibility = visibility_of(truth.objects[k], num_beams_[k], scan.geometry);
  }
  for (const WallPiece& piece : wall_pieces_.find(truth, scan)) {
    if (piece.is_resolvable()) truth.objects[piece.object].visibility = Visibility::kResolvable;
  }
}

void classify_visibility(Truth& truth, const LaserScan& scan) {
  VisibilityClassifier{}.classify(truth, scan);
}

}  // namespace scanbed
