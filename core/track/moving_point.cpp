// SPDX-License-Identifier: MIT
#include "core/track/moving_point.hpp"

namespace scanbed {

void MovingPoint::predict(double dt_s, double accel_psd_m2_per_s3) {
  const double dt2_s2 = dt_s * dt_s;
  p_m += dt_s * v_m_per_s;
  var_p_m2 +=
      2.0 * dt_s * cov_pv_m2_per_s + dt2_s2 * var_v_m2_per_s2 + accel_psd_m2_per_s3 * dt2_s2 * dt_s / 3.0;
  cov_pv_m2_per_s += dt_s * var_v_m2_per_s2 + accel_psd_m2_per_s3 * dt2_s2 / 2.0;
  var_v_m2_per_s2 += accel_psd_m2_per_s3 * dt_s;
}

void MovingPoint::correct(const Eigen::Vector2d& measured_m, double sigma_m) {
  const double innovation_var_m2 = var_p_m2 + sigma_m * sigma_m;
  const double gain_p = var_p_m2 / innovation_var_m2;
  const double gain_v_per_s = cov_pv_m2_per_s / innovation_var_m2;
  const Eigen::Vector2d innovation_m = measured_m - p_m;
  p_m += gain_p * innovation_m;
  v_m_per_s += gain_v_per_s * innovation_m;
  var_v_m2_per_s2 -= gain_v_per_s * cov_pv_m2_per_s;
  cov_pv_m2_per_s *= 1.0 - gain_p;
  var_p_m2 *= 1.0 - gain_p;
}

}  // namespace scanbed
