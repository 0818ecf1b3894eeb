// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace scanbed {

/// Estimate of a point that moves with almost constant velocity. Both axes share one covariance, since noise
/// is the same in every direction.
struct MovingPoint {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d v_m_per_s = Eigen::Vector2d::Zero();
  double var_p_m2 = 0.0;         ///< of each coordinate of p
  double cov_pv_m2_per_s = 0.0;  ///< between a coordinate of p and the same of v
  double var_v_m2_per_s2 = 0.0;  ///< of each coordinate of v

  /// Moves on by dt under white-noise acceleration of the given power spectral density.
  ///
  /// @param accel_psd_m2_per_s3  > 0; @param dt_s  >= 0.
  /// @par Source  Bar-Shalom, Li & Kirubarajan, "Estimation with Applications to Tracking and Navigation",
  ///              2001, section 6.2.2, the continuous white-noise acceleration model.
  void predict(double dt_s, double accel_psd_m2_per_s3);

  /// Takes in a measured position with standard deviation sigma_m > 0 along each axis.
  void correct(const Eigen::Vector2d& measured_m, double sigma_m);
};

}  // namespace scanbed
