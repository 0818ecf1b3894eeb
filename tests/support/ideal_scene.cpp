// SPDX-License-Identifier: MIT
#include "tests/support/ideal_scene.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/score/visibility.hpp"

namespace scanbed::testing {
namespace {

double range_to_wall_m(const Eigen::Vector2d& u, const ObjectTruth& wall) {
  const Eigen::Vector2d along_m = wall.to_m - wall.from_m;
  const double determinant = u.y() * along_m.x() - u.x() * along_m.y();
  if (determinant == 0.0) return kNoEcho;
  const double range_m = (wall.from_m.y() * along_m.x() - wall.from_m.x() * along_m.y()) / determinant;
  const double share = (wall.from_m.y() * u.x() - wall.from_m.x() * u.y()) / determinant;
  return range_m > 0.0 && share >= 0.0 && share <= 1.0 ? range_m : kNoEcho;
}

double range_to_cylinder_m(const Eigen::Vector2d& u, const ObjectTruth& cylinder) {
  const double nearest_m = u.dot(cylinder.center_m);
  const double across_m2 = cylinder.center_m.squaredNorm() - nearest_m * nearest_m;
  const double half_chord_m2 = cylinder.radius_m * cylinder.radius_m - across_m2;
  if (half_chord_m2 < 0.0) return kNoEcho;
  const double range_m = nearest_m - std::sqrt(half_chord_m2);
  return range_m > 0.0 ? range_m : kNoEcho;
}

}  // namespace

int IdealScene::wall(Eigen::Vector2d a_m, Eigen::Vector2d b_m) {
  ObjectTruth object;
  object.id = "wall" + std::to_string(objects_.size());
  object.label = "wall";
  object.primitive = Primitive::kLine;
  object.from_m = a_m;
  object.to_m = b_m;
  objects_.push_back(object);
  return static_cast<int>(objects_.size()) - 1;
}

int IdealScene::cylinder(Eigen::Vector2d center_m, double radius_m, Primitive primitive) {
  ObjectTruth object;
  object.id = "cylinder" + std::to_string(objects_.size());
  object.label = primitive == Primitive::kLeg ? "leg" : "column";
  object.primitive = primitive;
  object.center_m = center_m;
  object.radius_m = radius_m;
  objects_.push_back(object);
  return static_cast<int>(objects_.size()) - 1;
}

BeamTruth IdealScene::cast(double bearing_rad) const {
  const Eigen::Vector2d u(std::cos(bearing_rad), std::sin(bearing_rad));
  BeamTruth nearest{.range_m = kNoEcho};
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    const bool straight = objects_[k].primitive == Primitive::kLine;
    const double range_m = straight ? range_to_wall_m(u, objects_[k]) : range_to_cylinder_m(u, objects_[k]);
    if (range_m < nearest.range_m) nearest = {.object = static_cast<int>(k), .range_m = range_m};
  }
  return nearest;
}

LaserScan IdealScene::scan() const {
  LaserScan scan;
  scan.geometry = geometry_;
  for (int i = 0; i < geometry_.num_beams; ++i)
    scan.range_m.push_back(cast(geometry_.bearing_rad(i)).range_m);
  return scan;
}

Truth IdealScene::truth() const {
  Truth truth;
  truth.objects = objects_;
  for (int i = 0; i < geometry_.num_beams; ++i) truth.beams.push_back(cast(geometry_.bearing_rad(i)));
  classify_visibility(truth, scan());
  return truth;
}

LaserScan with_noise(LaserScan scan, double sigma_m, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> noise_m(0.0, sigma_m);
  for (double& range_m : scan.range_m) range_m += std::isfinite(range_m) ? noise_m(engine) : 0.0;
  return scan;
}

}  // namespace scanbed::testing
