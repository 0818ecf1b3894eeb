// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "core/geometry/angles.hpp"
#include "core/geometry/pose2.hpp"

namespace scanbed::testing {

inline constexpr double kRounding = 1e-12;

inline void expect_pose(const Pose2& pose, const Eigen::Vector2d& p_m, double theta_rad) {
  EXPECT_NEAR((pose.p_m - p_m).norm(), 0.0, kRounding) << pose.p_m.transpose();
  EXPECT_NEAR(wrap_to_pi(pose.theta_rad - theta_rad), 0.0, kRounding);
}

}  // namespace scanbed::testing
