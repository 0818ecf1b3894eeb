// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/detect/robust/echoes.hpp"

namespace scanbed {

/// A beam that passes an end of an arc and sees farther: the cylinder lies wholly on one side of it.
struct Witness {
  double ux = 0.0;
  double uy = 0.0;
};

/// A cylinder fitted to the echoes on its front.
struct ArcFit {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  double chi2 = 0.0;                                     ///< of the echoes and of the witnesses
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, radius), m2

  /// Range residual of an echo in units of its sigma. Range noise counts less where the surface turns away.
  double residual(const Echoes& echoes, int k) const;
};

/// Fits a cylinder to echoes, by damped Gauss-Newton on geometric distances from an algebraic (Kasa) start.
///
/// A few noisy beams leave the radius open; what fixes it is the silhouette: the witnesses must miss the
/// cylinder.
/// @param members  indices into echoes, at least 3.
/// @param start    where to begin in place of the algebraic fit: a fit of nearly the same echoes.
/// @returns empty where no cylinder in front of which the echoes lie can be fitted.
std::optional<ArcFit> fit_arc(const Echoes& echoes, std::span<const int> members,
                              std::span<const Witness> witnesses,
                              const std::optional<ArcFit>& start = std::nullopt);

}  // namespace scanbed
