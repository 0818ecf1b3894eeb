// SPDX-License-Identifier: MIT
#include "core/interpret/round_groups.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/interpret/circle_through_beams.hpp"

namespace scanbed {
namespace {

constexpr int kNoCircle = -1;
constexpr double kSolidRatio =
    0.7;  // two cylinders whose middles are nearer than this times r + r would overlap
constexpr double kMaxShift = 0.5;  // of a refined centre from the arcs' own, in radii: more is a bad fit
constexpr int kMaxSteps = 5;
constexpr double kConverged_m = 1e-4;
constexpr double kFeetAlike_m = 0.06;  // by which the radii of a bench's feet may differ
constexpr double kUnknownRatio = 0.8;  // of the score, where motion is not known yet

int num_beams(const Circle& circle) {
  return circle.beams.last - circle.beams.first + 1;
}

bool is_same_cylinder(const Circle& a, const Circle& b) {
  return (a.center_m - b.center_m).norm() < kSolidRatio * (a.radius_m + b.radius_m);
}

}  // namespace

void RoundGroups::find(const WatchedCircles& seen, const InterpretOptions& options, Scene& scene) {
  gather(seen);
  add_benches(options, scene);
  add_singles(options, scene);
}

void RoundGroups::gather(const WatchedCircles& seen) {
  const int num_circles = static_cast<int>(seen.circles.size());
  cylinders_.clear();
  next_.assign(num_circles, kNoCircle);
  is_later_.assign(num_circles, 0);
  for (int i = 0; i < num_circles; ++i) {
    if (is_later_[i] != 0 || seen.motions[i] == CircleMotion::kMobile) continue;
    const bool is_settled = join_others(seen, i);
    cylinders_.push_back(merge(seen.scan, seen.circles, i));
    cylinders_.back().is_settled = is_settled;
  }
}

// Links the later circles on the first one's cylinder to it. Returns whether one of them has been seen to
// stand.
bool RoundGroups::join_others(const WatchedCircles& seen, int first) {
  bool is_settled = seen.motions[first] == CircleMotion::kSettled;
  int last = first;
  for (int k = first + 1; k < static_cast<int>(seen.circles.size()); ++k) {
    if (is_later_[k] != 0 || seen.motions[k] == CircleMotion::kMobile) continue;
    if (!is_same_cylinder(seen.circles[first], seen.circles[k])) continue;
    next_[last] = k;
    last = k;
    is_later_[k] = 1;
    is_settled = is_settled || seen.motions[k] == CircleMotion::kSettled;
  }
  return is_settled;
}

RoundGroups::Cylinder RoundGroups::merge(const LaserScan& scan, const std::vector<Circle>& circles,
                                         int first) const {
  Cylinder cylinder{.center_m = Eigen::Vector2d::Zero(), .first_circle = first};
  double weight = 0.0;
  for (int i = first; i != kNoCircle; i = next_[i]) {
    const double beams = num_beams(circles[i]);
    cylinder.center_m += beams * circles[i].center_m;
    cylinder.radius_m += beams * circles[i].radius_m;
    cylinder.score = std::max(cylinder.score, circles[i].score);
    weight += beams;
  }
  cylinder.center_m /= weight;
  cylinder.radius_m /= weight;
  if (next_[first] == kNoCircle) return cylinder;
  CircleThroughBeams refined({cylinder.center_m, cylinder.radius_m});
  for (int step = 0; step < kMaxSteps; ++step) {
    for (int i = first; i != kNoCircle; i = next_[i]) refined.add(scan, circles[i].beams);
    const std::optional<double> moved_m = refined.step();
    if (!moved_m || *moved_m < kConverged_m) break;
  }
  const CircleFit& fit = refined.fit();
  const double limit_m = kMaxShift * cylinder.radius_m;
  if ((fit.center_m - cylinder.center_m).norm() < limit_m &&
      std::abs(fit.radius_m - cylinder.radius_m) < limit_m) {
    cylinder.center_m = fit.center_m;
    cylinder.radius_m = fit.radius_m;
  }
  return cylinder;
}

void RoundGroups::append_from(const Cylinder& cylinder, Scene& scene) const {
  for (int i = cylinder.first_circle; i != kNoCircle; i = next_[i]) {
    scene.from.push_back({Primitive::kCircle, i});
    ++scene.objects.back().num_from;
  }
}

void RoundGroups::add_benches(const InterpretOptions& options, Scene& scene) {
  pairs_.clear();
  const int num_cylinders = static_cast<int>(cylinders_.size());
  const auto may_be_a_foot = [&](const Cylinder& cylinder) {
    return cylinder.is_settled && cylinder.radius_m <= options.max_bench_radius_m;
  };
  for (int a = 0; a < num_cylinders; ++a) {
    for (int b = a + 1; b < num_cylinders && may_be_a_foot(cylinders_[a]); ++b) {
      const double apart_m = (cylinders_[a].center_m - cylinders_[b].center_m).norm();
      const double off_m = std::abs(apart_m - options.bench_gap_m);
      const bool are_alike = std::abs(cylinders_[a].radius_m - cylinders_[b].radius_m) <= kFeetAlike_m;
      if (!may_be_a_foot(cylinders_[b]) || !are_alike || off_m > options.bench_tolerance_m) continue;
      pairs_.push_back({off_m, a, b});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& left, const Pair& right) {
    return std::tie(left.off_m, left.a, left.b) < std::tie(right.off_m, right.a, right.b);
  });
  for (const Pair& pair : pairs_) {
    Cylinder& a = cylinders_[pair.a];
    Cylinder& b = cylinders_[pair.b];
    if (a.is_taken || b.is_taken) continue;
    a.is_taken = b.is_taken = true;
    scene.objects.push_back(
        {.kind = SceneKind::kBench,
         .center_m = (a.center_m + b.center_m) / 2,
         .left_m = a.center_m,
         .right_m = b.center_m,
         .radius_m = (a.radius_m + b.radius_m) / 2,
         .score = std::min(a.score, b.score) * (1.0 - 0.5 * pair.off_m / options.bench_tolerance_m),
         .first_from = static_cast<int>(scene.from.size())});
    append_from(a, scene);
    append_from(b, scene);
  }
}

void RoundGroups::add_singles(const InterpretOptions& options, Scene& scene) const {
  for (const Cylinder& cylinder : cylinders_) {
    if (cylinder.is_taken) continue;
    const bool is_trash_can = cylinder.radius_m >= options.min_trash_can_radius_m &&
                              cylinder.radius_m <= options.max_trash_can_radius_m;
    scene.objects.push_back({.kind = is_trash_can ? SceneKind::kTrashCan : SceneKind::kColumn,
                             .center_m = cylinder.center_m,
                             .radius_m = cylinder.radius_m,
                             .score = cylinder.score * (cylinder.is_settled ? 1.0 : kUnknownRatio),
                             .first_from = static_cast<int>(scene.from.size())});
    append_from(cylinder, scene);
  }
}

}  // namespace scanbed
