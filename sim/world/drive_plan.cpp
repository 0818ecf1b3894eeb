// SPDX-License-Identifier: MIT
#include "sim/world/drive_plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scanbed::sim {
namespace {

/// How long a step takes and how fast the robot is meanwhile.
struct Motion {
  double duration_s = 0.0;
  double speed_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;
};

struct MotionOf {
  const Robot& robot;

  Motion operator()(const Wait& wait) const { return {wait.duration_s, 0.0, 0.0}; }
  Motion operator()(const Turn& turn) const {
    return {std::abs(turn.angle_rad) / robot.turn_rad_per_s, 0.0,
            std::copysign(robot.turn_rad_per_s, turn.angle_rad)};
  }
  Motion operator()(const Go& go) const {
    return {std::abs(go.distance_m) / robot.speed_m_per_s, std::copysign(robot.speed_m_per_s, go.distance_m),
            0.0};
  }
};

}  // namespace

DrivePlan::DrivePlan(const Robot& robot) {
  double time_s = 0.0;
  Pose2 X_WR = robot.X_WR;
  for (const DriveStep& step : robot.drive) {
    const Motion motion = std::visit(MotionOf{robot}, step);
    legs_.push_back({time_s, X_WR, motion.speed_m_per_s, motion.turn_rad_per_s});
    time_s += motion.duration_s;
    X_WR = pose_at(time_s);
  }
  legs_.push_back({time_s, X_WR, 0.0, 0.0});
}

Pose2 DrivePlan::pose_at(double time_s) const {
  const auto behind = std::upper_bound(std::next(legs_.begin()), legs_.end(), time_s,
                                       [](double t, const Leg& leg) { return t < leg.start_s; });
  const Leg& leg = *std::prev(behind);
  const double driven_s = std::max(0.0, time_s - leg.start_s);
  return {leg.X_WR.p_m + driven_s * leg.speed_m_per_s * leg.X_WR.heading(),
          wrap_to_pi(leg.X_WR.theta_rad + driven_s * leg.turn_rad_per_s)};
}

}  // namespace scanbed::sim
