// SPDX-License-Identifier: MIT
#include "sim/world/gait.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kNormalStep_m = 0.72;
constexpr double kNormalSpeed_m_per_s = 1.37;
constexpr double kLeft = 1.0;
constexpr double kRight = -1.0;

}  // namespace

double step_length_m(double speed_m_per_s) {
  return kNormalStep_m * std::sqrt(speed_m_per_s / kNormalSpeed_m_per_s);
}

double cycle_s(double speed_m_per_s) {
  return 2.0 * step_length_m(speed_m_per_s) / speed_m_per_s;
}

Gait::Gait(const Walker& walker, int index, double height_m)
    : path_(walker.path),
      index_(index),
      start_s_(walker.start_s),
      speed_m_per_s_(walker.speed_m_per_s),
      step_width_m_(walker.step_width_m),
      leg_ratio_(std::min(height_m / walker.leg_length_m, 1.0)),
      leaves_(walker.path.leave && !walker.path.loop),
      loop_(walker.path.loop) {}

// In the middle of a foot's n-th stance the pelvis has walked n strides and is over it. Right feet are half a
// cycle late.
Vector2d Gait::footprint_m(double cycle, double side) const {
  const double late = side == kRight ? 0.5 : 0.0;
  const double along_m = (cycle + late) * 2.0 * step_length_m(speed_m_per_s_);
  const double ahead_m = std::max(along_m, 0.0);
  const Pose2 X_WF = path_.pose_at(loop_ ? ahead_m : std::min(ahead_m, path_.length_m()));
  return X_WF * Vector2d(std::min(along_m, 0.0), 0.5 * side * step_width_m_);
}

Vector2d Gait::foot_m(double walked_s, double side) const {
  const double late = side == kRight ? 0.5 : 0.0;
  const double phase = walked_s / cycle_s(speed_m_per_s_) + 0.5 * kStanceRatio - late;
  const double cycle = std::floor(phase);
  Vector2d stands = footprint_m(cycle, side);
  const double swung = (phase - cycle - kStanceRatio) / (1.0 - kStanceRatio);
  if (swung <= 0.0) return stands;
  return stands + swung * (footprint_m(cycle + 1.0, side) - stands);
}

WalkerState Gait::state_at(double time_s) const {
  const double walked_s = std::max(0.0, time_s - start_s_);
  const double walked_m = walked_s * speed_m_per_s_;
  WalkerState state;
  state.walker = index_;
  state.present = time_s >= start_s_ && !(leaves_ && walked_m > path_.length_m());
  state.X_WP = path_.pose_at(walked_m);
  state.left_foot_m = foot_m(walked_s, kLeft);
  state.right_foot_m = foot_m(walked_s, kRight);
  const Vector2d left_hip = state.X_WP * Vector2d(0.0, 0.5 * kHipWidth_m);
  const Vector2d right_hip = state.X_WP * Vector2d(0.0, -0.5 * kHipWidth_m);
  state.left_leg_m = state.left_foot_m + leg_ratio_ * (left_hip - state.left_foot_m);
  state.right_leg_m = state.right_foot_m + leg_ratio_ * (right_hip - state.right_foot_m);
  return state;
}

}  // namespace scanbed::sim
