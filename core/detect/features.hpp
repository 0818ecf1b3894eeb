// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

namespace scanbed {

/// Beams of a scan, both ends included: Table I's fields 1 and 2.
struct BeamSpan {
  int first = 0;
  int last = 0;
};

/// Table I, column Line; sensor frame S. y = slope * x + bias; both are empty for a line along y.
struct Line {
  BeamSpan beams;
  /// Ends at beams.first and beams.last, on the fitted line; of the robust pipeline at the corner, where the
  /// line makes one with its neighbour.
  Eigen::Vector2d left_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d right_m = Eigen::Vector2d::Zero();
  std::optional<double> slope;
  std::optional<double> bias_m;
  int num_points = 0;
  double error_m = 0.0;  ///< largest distance of a point to the line
  double score = 0.0;    ///< [0, 1]
  /// Of normal bearing a (rad) and distance d (m), d > 0, in x cos(a) + y sin(a) = d; of the robust pipeline
  /// alone.
  std::optional<Eigen::Matrix2d> covariance = {};

  /// Sets slope and bias to those of the line through a point along a unit direction. Where that runs along y
  /// so nearly that a slope says nothing, both stay empty.
  void set_equation(const Eigen::Vector2d& p_m, const Eigen::Vector2d& along);
};

inline void Line::set_equation(const Eigen::Vector2d& p_m, const Eigen::Vector2d& along) {
  constexpr double kMinCosine = 1e-6;
  slope.reset();
  bias_m.reset();
  if (std::abs(along.x()) <= kMinCosine) return;
  slope = along.y() / along.x();
  bias_m = p_m.y() - *slope * p_m.x();
}

/// Table I, column Circle; sensor frame S.
struct Circle {
  BeamSpan beams;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  std::optional<double> average_rad;  ///< mean inscribed angle; of the paper's detector alone
  std::optional<double> std_rad;      ///< standard deviation of the inscribed angles; of that alone too
  double score = 0.0;                 ///< [0, 1]
  /// Of center x, y and radius, m2; of the robust pipeline alone.
  std::optional<Eigen::Matrix3d> covariance = {};
};

/// Table I, column Leg; sensor frame S.
struct Leg {
  BeamSpan beams;
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< the segment's middle point
  double score = 0.0;                                  ///< [0, 1]
};

/// What one scan holds. Each list rises in beams.first.
struct Features {
  std::vector<Line> lines;
  std::vector<Circle> circles;
  /// Of too few echoes to be reported, but legs are told by them too.
  std::vector<Circle> doubtful_circles;
  std::vector<Leg> legs;
  /// Too unlikely to be reported, but if tracking finds them again and again, somebody is there.
  std::vector<Leg> doubtful_legs;

  void clear() {
    lines.clear();
    circles.clear();
    doubtful_circles.clear();
    legs.clear();
    doubtful_legs.clear();
  }
};

}  // namespace scanbed
