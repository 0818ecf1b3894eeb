// SPDX-License-Identifier: MIT
#include "sim/world/gait.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/world/crowd.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kNormalStep_m = 0.72;
constexpr double kNormalSpeed_m_per_s = 1.37;
constexpr double kLeft = 1.0;
constexpr double kRight = -1.0;
constexpr double kForever = std::numeric_limits<double>::infinity();

}  // namespace

double step_length_m(double speed_m_per_s) {
  return kNormalStep_m * std::sqrt(speed_m_per_s / kNormalSpeed_m_per_s);
}

double cycle_s(double speed_m_per_s) {
  return 2.0 * step_length_m(speed_m_per_s) / speed_m_per_s;
}

double shortest_stop_s(double speed_m_per_s, double turn_rad) {
  return cycle_s(speed_m_per_s) + 2.0 * std::abs(turn_rad) / kTurnOnTheSpot_rad_per_s;
}

Gait::Gait(const Walker& walker, int index, double height_m)
    : path_(walker.path),
      index_(index),
      start_s_(walker.start_s),
      leave_s_(kForever),
      speed_m_per_s_(walker.speed_m_per_s),
      step_width_m_(walker.step_width_m),
      lateral_m_(walker.lateral_m),
      leg_ratio_(std::min(height_m / walker.leg_length_m, 1.0)) {
  const double end_m = walker.path.loop ? kForever : path_.length_m();
  double start_s = start_s_;
  double from_m = 0.0;
  for (const Stop& stop : walker.stops) {
    if (stop.at_m > end_m || start_s == kForever) break;
    const double behind_s = start_s + (stop.at_m - from_m) / speed_m_per_s_ + stop.for_s;
    stretches_.push_back({start_s, from_m, stop.at_m, stop.turn_rad, behind_s});
    start_s = behind_s;
    from_m = stop.at_m;
  }
  if (start_s == kForever) return;
  stretches_.push_back({start_s, from_m, end_m, 0.0, kForever});
  if (walker.path.leave && !walker.path.loop) leave_s_ = start_s + (end_m - from_m) / speed_m_per_s_;
}

Gait::Moment Gait::moment(double time_s, const SideStep* aside) const {
  std::size_t k = 0;
  while (k + 1 < stretches_.size() && stretches_[k + 1].start_s <= time_s) ++k;
  const Stretch& stretch = stretches_[k];
  return {stretch, std::max(time_s, stretch.start_s), aside,
          stretch.start_s + (stretch.to_m - stretch.from_m) / speed_m_per_s_};
}

// Evenly there after one cycle of standing, evenly back before the next stretch.
double Gait::turned_rad(const Moment& now) const {
  const double turn_rad = now.stretch.turn_rad;
  if (turn_rad == 0.0) return 0.0;
  const double there_rad = kTurnOnTheSpot_rad_per_s * (now.time_s - now.arrival_s - cycle_s(speed_m_per_s_));
  const double back_rad = kTurnOnTheSpot_rad_per_s * (now.stretch.behind_s - now.time_s);
  return std::copysign(std::clamp(std::min(there_rad, back_rad), 0.0, std::abs(turn_rad)), turn_rad);
}

Pose2 Gait::pose(const Moment& now) const {
  const double walked_m = (now.time_s - now.stretch.start_s) * speed_m_per_s_;
  const Pose2 X_WP = path_.pose_at(std::min(now.stretch.from_m + walked_m, now.stretch.to_m));
  const double left_m = lateral_m_ + (now.aside != nullptr ? now.aside->to_the_left_m(now.time_s) : 0.0);
  // Most keep to their path most of the time: no sine and cosine for these.
  const Vector2d p_m = left_m == 0.0 ? X_WP.p_m : X_WP * Vector2d(0.0, left_m);
  return {p_m, X_WP.theta_rad + turned_rad(now)};
}

Pose2 Gait::pose_at(double time_s) const {
  return pose(moment(time_s, nullptr));
}

double Gait::presence(double time_s) const {
  return std::clamp(std::min(time_s - start_s_, leave_s_ - time_s), 0.0, 1.0);
}

// In the middle of a foot's n-th stance the pelvis has walked n strides and is over it. Right feet are half a
// cycle late. Who stands shifts both feet as the pelvis steps aside or turns.
Vector2d Gait::footprint_m(const Moment& now, double cycle, double side) const {
  const double late = side == kRight ? 0.5 : 0.0;
  const double along_m = std::max((cycle + late) * 2.0 * step_length_m(speed_m_per_s_), 0.0);
  const double over_s = std::min(now.stretch.start_s + along_m / speed_m_per_s_, now.arrival_s);
  const bool stands = over_s == now.arrival_s && now.time_s > now.arrival_s;
  const Moment then{now.stretch, stands ? now.time_s : over_s, now.aside, now.arrival_s};
  return pose(then) * Vector2d(0.0, 0.5 * side * step_width_m_);
}

Vector2d Gait::foot_m(const Moment& now, double side) const {
  const double late = side == kRight ? 0.5 : 0.0;
  const double walked_s = now.time_s - now.stretch.start_s;
  const double phase = walked_s / cycle_s(speed_m_per_s_) + 0.5 * kStanceRatio - late;
  const double cycle = std::floor(phase);
  Vector2d stands = footprint_m(now, cycle, side);
  double swung = (phase - cycle - kStanceRatio) / (1.0 - kStanceRatio);
  if (swung <= 0.0) return stands;
  // The right foot starts from beside the left one, in the middle of its swing.
  if (cycle < 0.0) swung = 2.0 * swung - 1.0;
  return stands + swung * (footprint_m(now, cycle + 1.0, side) - stands);
}

WalkerState Gait::state_at(double time_s, const SideStep* aside) const {
  const Moment now = moment(time_s, aside);
  WalkerState state;
  state.walker = index_;
  state.present = time_s >= start_s_ && time_s <= leave_s_;
  state.X_WP = pose(now);
  state.left_foot_m = foot_m(now, kLeft);
  state.right_foot_m = foot_m(now, kRight);
  const Vector2d left_hip = state.X_WP * Vector2d(0.0, 0.5 * kHipWidth_m);
  const Vector2d right_hip = state.X_WP * Vector2d(0.0, -0.5 * kHipWidth_m);
  state.left_leg_m = state.left_foot_m + leg_ratio_ * (left_hip - state.left_foot_m);
  state.right_leg_m = state.right_foot_m + leg_ratio_ * (right_hip - state.right_foot_m);
  return state;
}

}  // namespace scanbed::sim
