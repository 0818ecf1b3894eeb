// SPDX-License-Identifier: MIT
#include "core/detect/full_turn.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"

namespace scanbed {
namespace {

constexpr int kMinBeams = 8;
constexpr double kNothing_m = 1000.0;  // where a beam without echo ends, to compare it with others

// The beam behind the largest step of range.
int beam_behind_largest_step(const LaserScan& scan, int num_beams) {
  const auto end_m = [&](int beam) { return scan.has_echo(beam) ? scan.range_m[beam] : kNothing_m; };
  int begin = 0;
  double largest_m = -1.0;
  double before_m = end_m(num_beams - 1);
  for (int beam = 0; beam < num_beams; ++beam) {
    const double here_m = end_m(beam);
    const double step_m = std::abs(here_m - before_m);
    if (step_m > largest_m) {
      largest_m = step_m;
      begin = beam;
    }
    before_m = here_m;
  }
  return begin;
}

}  // namespace

int num_beams_in_turn(const LaserScan& scan) {
  const double turn = 2.0 * kPi / std::abs(scan.geometry.step_rad);
  const int num_beams = scan.num_beams();
  if (num_beams < kMinBeams || !std::isfinite(scan.geometry.first_rad)) return 0;
  if (std::abs(num_beams - turn) < 0.5) return num_beams;
  return std::abs(num_beams - 1 - turn) < 0.5 ? num_beams - 1 : 0;
}

int num_beams_to_same_direction(const ScanGeometry& geometry) {
  constexpr double kMost = 1e9;
  return static_cast<int>(std::min(kMost, std::round(2.0 * kPi / std::abs(geometry.step_rad))));
}

BeamSpan middle_turn(const LaserScan& scan) {
  const int num_in_turn = num_beams_to_same_direction(scan.geometry);
  const int num_before = std::max(0, scan.num_beams() - num_in_turn) / 2;
  return {num_before, std::min(scan.num_beams(), num_before + num_in_turn) - 1};
}

const LaserScan& FullTurn::unroll(const LaserScan& scan) {
  num_beams_ = num_beams_in_turn(scan);
  if (num_beams_ == 0) return scan;
  begin_ = beam_behind_largest_step(scan, num_beams_);
  // No line goes on through more than half a turn: of two views of one, one is whole.
  margin_ = num_beams_ / 4 + 1;
  X_SU_.theta_rad = scan.geometry.bearing_rad(begin_);
  const int num_unrolled = num_beams_ + 2 * margin_;
  unrolled_.range_m.resize(num_unrolled);
  for (int i = 0; i < num_unrolled; ++i) {
    unrolled_.range_m[i] = scan.range_m[(begin_ - margin_ + num_beams_ + i) % num_beams_];
  }
  // Always in the frame of the beam at which the turn begins: the beams' directions need not be found anew.
  unrolled_.geometry = scan.geometry;
  unrolled_.geometry.num_beams = num_unrolled;
  unrolled_.geometry.first_rad = -margin_ * scan.geometry.step_rad;
  return unrolled_;
}

BeamSpan FullTurn::rolled(const BeamSpan& beams) const {
  const auto beam_of = [&](int unrolled) { return (unrolled - margin_ + begin_ + num_beams_) % num_beams_; };
  const BeamSpan span{beam_of(beams.first), beam_of(beams.last)};
  if (span.first <= span.last) return span;
  const int num_before_seam = num_beams_ - span.first;
  return num_before_seam > span.last ? BeamSpan{span.first, num_beams_ - 1} : BeamSpan{0, span.last};
}

void FullTurn::turn(Line& line) const {
  line.left_m = X_SU_ * line.left_m;
  line.right_m = X_SU_ * line.right_m;
  line.set_equation(line.left_m, (line.right_m - line.left_m).normalized());
}

void FullTurn::turn(Circle& circle) const {
  circle.center_m = X_SU_ * circle.center_m;
  if (!circle.covariance) return;
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(X_SU_.theta_rad).toRotationMatrix();
  circle.covariance = turned * *circle.covariance * turned.transpose();
}

void FullTurn::turn(Leg& leg) const {
  leg.middle_m = X_SU_ * leg.middle_m;
}

template <typename Feature>
void FullTurn::roll(std::vector<Feature>& features) const {
  std::erase_if(features, [&](const Feature& feature) {
    const int middle = (feature.beams.first + feature.beams.last) / 2 - margin_;
    return middle < 0 || middle >= num_beams_;
  });
  for (Feature& feature : features) {
    feature.beams = rolled(feature.beams);
    turn(feature);
  }
  std::sort(features.begin(), features.end(),
            [](const Feature& a, const Feature& b) { return a.beams.first < b.beams.first; });
}

void FullTurn::roll(Features& features) const {
  if (num_beams_ == 0) return;
  roll(features.lines);
  roll(features.circles);
  roll(features.doubtful_circles);
  roll(features.legs);
  roll(features.doubtful_legs);
}

}  // namespace scanbed
