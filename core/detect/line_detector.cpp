// SPDX-License-Identifier: MIT
#include "core/detect/line_detector.hpp"

#include <algorithm>
#include <cmath>

#include "core/detect/inscribed_angles.hpp"

namespace scanbed {
namespace {

int farthest_from_chord(const Points& points, const Segment& run) {
  const Chord chord = chord_of(points, run);
  int farthest = run.first + 1;
  double greatest_m = -1.0;
  for (int k = run.first + 1; k < run.last; ++k) {
    const double distance_m =
        chord.length_m > 0.0 ? std::abs(chord.depth_m(points[k])) : (points[k] - chord.from_m).norm();
    if (distance_m > greatest_m) {
      greatest_m = distance_m;
      farthest = k;
    }
  }
  return farthest;
}

Line line_of(const Points& points, const Segment& run, const LineFit& fit) {
  Line line;
  line.beams = {points.beam[run.first], points.beam[run.last]};
  line.left_m = fit.foot_of(points[run.first]);
  line.right_m = fit.foot_of(points[run.last]);
  line.set_equation(fit.centroid_m, fit.direction);
  line.num_points = run.num_points();
  return line;
}

}  // namespace

void LineDetector::sum_moments(const Points& points, const Segment& segment) {
  origin_m_ = points[segment.first];
  origin_index_ = segment.first;
  moments_.resize(segment.num_points() + 1);
  moments_[0] = {};
  for (int k = 0; k < segment.num_points(); ++k) {
    const Eigen::Vector2d p_m = points[segment.first + k] - origin_m_;
    moments_[k + 1] = moments_[k];
    moments_[k + 1].add(p_m.x(), p_m.y());
  }
}

LineDetector::Fit LineDetector::fit(const Points& points, const Segment& run) const {
  Fit result;
  result.line = fit_line(moments_[run.last + 1 - origin_index_] - moments_[run.first - origin_index_]);
  result.line.centroid_m += origin_m_;
  for (int k = run.first; k <= run.last; ++k) {
    result.error_m = std::max(result.error_m, result.line.distance_m(points[k]));
  }
  return result;
}

bool LineDetector::accepts(const Points& points, const Segment& run, const Fit& fit) const {
  if (options_.method == LineMethod::kRecursiveFit) return fit.error_m <= options_.max_error_m;
  const std::optional<InscribedAngles> angles = inscribed_angles(points, run, BehindChord::kReflex);
  return angles && std::abs(angles->average_rad - kPi) <= options_.max_average_deviation_rad &&
         angles->std_rad <= options_.max_std_rad;
}

void LineDetector::detect(const Points& points, const Segment& segment, std::vector<Line>& lines) {
  if (options_.method == LineMethod::kOff || segment.num_points() < options_.min_points) return;
  sum_moments(points, segment);
  pending_.assign(1, segment);
  while (!pending_.empty()) {
    const Segment run = pending_.back();
    pending_.pop_back();
    if (run.num_points() < options_.min_points) continue;
    if ((points[run.last] - points[run.first]).norm() < options_.min_length_m) continue;
    const Fit fitted = fit(points, run);
    if (accepts(points, run, fitted)) {
      lines.push_back(line_of(points, run, fitted.line));
      lines.back().error_m = fitted.error_m;
      lines.back().score =
          (1.0 - 1.0 / run.num_points()) * (1.0 - 0.5 * std::min(1.0, fitted.error_m / options_.max_error_m));
    } else if (run.num_points() > 2) {
      const int split = farthest_from_chord(points, run);
      pending_.push_back({split, run.last});  // taken up last, so that lines come out in rising order
      pending_.push_back({run.first, split});
    }
  }
}

}  // namespace scanbed
