// SPDX-License-Identifier: MIT
#include "sim/world/drive_plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "core/errors/input_error.hpp"
#include "sim/world/world_limits.hpp"

namespace scanbed::sim {
namespace {

struct MotionsOf {
  const Robot& robot;
  const Pose2& X_WR;

  std::vector<Motion> operator()(const Wait& wait) const { return {{wait.duration_s, 0.0, 0.0}}; }
  std::vector<Motion> operator()(const Turn& turn) const {
    return {{std::abs(turn.angle_rad) / robot.turn_rad_per_s, 0.0,
             std::copysign(robot.turn_rad_per_s, turn.angle_rad)}};
  }
  std::vector<Motion> operator()(const Go& go) const {
    return {{std::abs(go.distance_m) / robot.speed_m_per_s, std::copysign(robot.speed_m_per_s, go.distance_m),
             0.0}};
  }
  std::vector<Motion> operator()(const FollowPath& path) const { return motions_along(path, X_WR, robot); }
  std::vector<Motion> operator()(const FollowLegs& legs) const { return {{legs.for_s, 0.0, 0.0}}; }
};

struct CheckStep {
  const std::string& name;

  void operator()(const Wait& wait) const {
    require(std::isfinite(wait.duration_s) && wait.duration_s >= 0.0, name + ": wait", wait.duration_s,
            "finite, >= 0");
  }
  void operator()(const Turn& turn) const {
    require(std::abs(turn.angle_rad) <= 1e3 * kPi, name + ": turn", turn.angle_rad, "at most 500 turns");
  }
  void operator()(const Go& go) const {
    require(std::abs(go.distance_m) <= kFarthest_m, name + ": go", go.distance_m, "at most 1000 m");
  }
  void operator()(const FollowPath& path) const { validate_path(path, name); }
  void operator()(const FollowLegs& legs) const {
    const std::string follow = name + ": follow: ";
    require(legs.distance_m > 0.0 && legs.distance_m <= kFarthest_m, follow + "distance_m", legs.distance_m,
            "(0, 1000]");
    require(legs.for_s > 0.0, follow + "for_s", legs.for_s, "> 0");
    require(legs.within_m > 0.0 && legs.within_m <= kFarthest_m, follow + "within_m", legs.within_m,
            "(0, 1000]");
    require(legs.patience_s >= 0.0 && legs.patience_s <= 60.0, follow + "patience_s", legs.patience_s,
            "[0, 60]");
  }
};

}  // namespace

DrivePlan::DrivePlan(const Robot& robot) : robot_(robot) {
  plan_from(0, 0.0, robot_.X_WR);
}

void DrivePlan::plan_from(std::size_t step, double start_s, const Pose2& X_WR) {
  double time_s = start_s;
  Pose2 X_WN = X_WR;  // N: the robot at the next leg's start
  for (; step < robot_.drive.size() && std::isfinite(time_s); ++step) {
    for (const Motion& motion : std::visit(MotionsOf{robot_, X_WN}, robot_.drive[step])) {
      legs_.push_back({time_s, X_WN, motion, step});
      time_s += motion.duration_s;
      if (std::isfinite(time_s)) X_WN = motion.pose_behind(X_WN, motion.duration_s);
    }
  }
  legs_.push_back({time_s, X_WN, {}, robot_.drive.size()});
}

const DrivePlan::Leg& DrivePlan::leg_at(double time_s) const {
  const auto behind = std::upper_bound(std::next(legs_.begin()), legs_.end(), time_s,
                                       [](double t, const Leg& leg) { return t < leg.start_s; });
  return *std::prev(behind);
}

Pose2 DrivePlan::pose_at(double time_s) const {
  const Leg& leg = leg_at(time_s);
  return leg.motion.pose_behind(leg.X_WR, std::max(0.0, time_s - leg.start_s));
}

const FollowLegs* DrivePlan::following_at(double time_s) const {
  const Leg& leg = leg_at(time_s);
  return leg.step < robot_.drive.size() ? std::get_if<FollowLegs>(&robot_.drive[leg.step]) : nullptr;
}

void DrivePlan::command(double from_s, const DriveCommand& command) {
  if (following_at(from_s) == nullptr) return;
  const Leg leg = leg_at(from_s);
  const Pose2 X_WR = pose_at(from_s);
  // What follows begins where this step will lead, so it is planned anew; what lies before the last command
  // is not asked for any more.
  const auto from = [](const Leg& a, double t) { return a.start_s < t; };
  legs_.erase(std::lower_bound(legs_.begin(), legs_.end(), from_s, from), legs_.end());
  const auto asked = std::lower_bound(legs_.begin(), legs_.end(), last_command_s_, from);
  if (asked != legs_.begin()) legs_.erase(legs_.begin(), std::prev(asked));
  last_command_s_ = from_s;
  const Motion motion{leg.start_s + leg.motion.duration_s - from_s, command.speed_m_per_s,
                      command.turn_rad_per_s};
  legs_.push_back({from_s, X_WR, motion, leg.step});
  const double end_s = from_s + motion.duration_s;
  plan_from(leg.step + 1, end_s, std::isfinite(end_s) ? motion.pose_behind(X_WR, motion.duration_s) : X_WR);
}

void validate_drive(const Robot& robot) {
  for (std::size_t i = 0; i < robot.drive.size(); ++i) {
    const std::string name = "robot: drive step " + std::to_string(i);
    std::visit(CheckStep{name}, robot.drive[i]);
  }
}

}  // namespace scanbed::sim
