// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// A beam that passes an end of an arc and sees farther: the cylinder lies wholly on one side of it.
struct Witness {
  double ux = 0.0;
  double uy = 0.0;
};

struct Cylinder {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};

/// A cylinder fitted to the echoes on its front.
struct ArcFit {
  Cylinder cylinder;
  double chi2 = 0.0;                                      ///< of the echoes and of the witnesses
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< inverse covariance of (x, y, radius), 1/m2

  /// Squared range residual of an echo in units of its variance. Range noise counts less where the surface
  /// turns away.
  double squared_residual(const Echoes& echoes, int k) const;

  /// Of (x, y, radius), m2; empty where the echoes leave one of them open.
  std::optional<Eigen::Matrix3d> covariance() const;
};

/// What an arc is fitted to.
struct ArcEvidence {
  std::span<const Stretch> parts;      ///< stretches of echoes, at least 3 echoes in all
  std::span<const Witness> witnesses;  ///< beams that must miss the cylinder
};

/// Fits a cylinder to echoes, by damped Gauss-Newton on geometric distances.
///
/// A few noisy beams leave the radius open; what fixes it is the silhouette: the witnesses must miss the
/// cylinder.
/// @param start      a fit of nearly the same echoes, or by simpler means.
/// @param most_chi2  fits that promise to leave far more are given up early.
/// @returns empty where no cylinder in front of which the echoes lie can be fitted.
std::optional<ArcFit> fit_arc(const Echoes& echoes, const ArcEvidence& evidence, const Cylinder& start,
                              double most_chi2);

}  // namespace scanbed
