// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Normal equations of a circle that points are to lie on.
struct CircleFit {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};

/// Refines a circle on the echoes of several arcs at once: Gauss-Newton on geometric distances.
class CircleThroughBeams {
 public:
  explicit CircleThroughBeams(const CircleFit& start) : fit_(start) {}

  /// Adds the echoes of an arc to the step that is being taken.
  void add(const LaserScan& scan, const BeamSpan& beams);

  /// Takes the step on all that was added. @returns how far the centre moved; empty where the echoes leave
  /// the circle open, which then stays as it was.
  std::optional<double> step();

  const CircleFit& fit() const { return fit_; }

 private:
  CircleFit fit_;
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d side_ = Eigen::Vector3d::Zero();
};

}  // namespace scanbed
