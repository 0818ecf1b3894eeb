// SPDX-License-Identifier: MIT
#include "sim/world/leg_follower.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

// Shins at laser height: up to 0.5 m apart in a step of 0.72 m, a leg's width when they pass.
constexpr double kMostApart_m = 0.7;
constexpr double kLeastApart_m = 0.05;
// How far a person's next sight may lie from where they were expected.
constexpr double kGate_m = 0.6;
// Weights of a sight against what was expected (an alpha-beta filter). A single leg swings ahead of its
// person and falls behind, so it counts for less.
constexpr double kPairWeight = 0.5;
constexpr double kLegWeight = 0.2;
constexpr double kSpeedWeight = 0.15;  // per kPairWeight
constexpr double kFastest_m_per_s = 2.5;
// Parts of the remaining error that are driven away per second, and at most within one command: more would
// overshoot before the next scan shows it.
constexpr double kApproach_per_s = 1.0;
constexpr double kTurn_per_s = 1.5;
constexpr double kMostPerCommand = 0.5;

// Nearest to p_m of those within reach.
std::optional<Vector2d> nearest(const std::vector<Vector2d>& places_m, const Vector2d& p_m, double reach_m) {
  std::optional<Vector2d> found;
  for (const Vector2d& place : places_m) {
    const double away_m = (place - p_m).norm();
    if (away_m > reach_m) continue;
    reach_m = away_m;
    found = place;
  }
  return found;
}

void find_pairs(const std::vector<Vector2d>& legs_m, std::vector<Vector2d>& pairs_m) {
  pairs_m.clear();
  for (std::size_t i = 0; i < legs_m.size(); ++i) {
    for (std::size_t j = i + 1; j < legs_m.size(); ++j) {
      const double apart_m = (legs_m[i] - legs_m[j]).norm();
      if (apart_m >= kLeastApart_m && apart_m <= kMostApart_m) {
        pairs_m.push_back(0.5 * (legs_m[i] + legs_m[j]));
      }
    }
  }
}

}  // namespace

std::optional<Vector2d> LegFollower::person_m() const {
  if (!person_) return std::nullopt;
  return person_->p_m;
}

void LegFollower::take_up(const Sight& sight) {
  const Vector2d p_WS = sight.X_WR * robot_.X_RS.p_m;
  const std::optional<Vector2d> pair = nearest(pairs_m_, p_WS, task_.within_m);
  if (pair) person_ = Person{*pair, Vector2d::Zero(), sight.time_s};
}

void LegFollower::keep_to(const Sight& sight) {
  Person& person = *person_;
  const double step_s = sight.time_s - time_s_;
  person.p_m += step_s * person.v_m_per_s;
  const std::optional<Vector2d> pair = nearest(pairs_m_, person.p_m, kGate_m);
  const std::optional<Vector2d> seen = pair ? pair : nearest(legs_m_, person.p_m, kGate_m);
  if (!seen) {
    if (sight.time_s - person.seen_s > task_.patience_s) person_.reset();
    return;
  }
  const double weight = pair ? kPairWeight : kLegWeight;
  const Vector2d miss_m = *seen - person.p_m;
  person.p_m += weight * miss_m;
  if (step_s > 0.0) person.v_m_per_s += weight / kPairWeight * kSpeedWeight / step_s * miss_m;
  const double speed_m_per_s = person.v_m_per_s.norm();
  if (speed_m_per_s > kFastest_m_per_s) person.v_m_per_s *= kFastest_m_per_s / speed_m_per_s;
  person.seen_s = sight.time_s;
}

DriveCommand LegFollower::steer(const Sight& sight) const {
  const Motion motion{sight.period_s, command_.speed_m_per_s, command_.turn_rad_per_s};
  const Pose2 X_WR = motion.pose_behind(sight.X_WR, sight.period_s);
  const Vector2d p_RQ = X_WR.inverse() * (person_->p_m + sight.period_s * person_->v_m_per_s);
  const Vector2d p_SQ = p_RQ - robot_.X_RS.p_m;
  const double ahead = std::cos(std::atan2(p_RQ.y(), p_RQ.x()));
  const double away_m_per_s = person_->v_m_per_s.dot(X_WR.rotate(p_SQ.normalized()));
  const double part = kMostPerCommand / sight.period_s;
  const double speed_m_per_s =
      away_m_per_s + std::min(kApproach_per_s, part) * (p_SQ.norm() - task_.distance_m);
  const double turn_rad_per_s = std::min(kTurn_per_s, part) * std::atan2(p_RQ.y(), p_RQ.x());
  return {std::clamp(std::max(ahead, 0.0) * speed_m_per_s, 0.0, robot_.speed_m_per_s),
          std::clamp(turn_rad_per_s, -robot_.turn_rad_per_s, robot_.turn_rad_per_s)};
}

DriveCommand LegFollower::update(const Sight& sight) {
  legs_m_.clear();
  const Pose2 X_WS = sight.X_WR * robot_.X_RS;
  for (const Leg& leg : sight.legs) legs_m_.push_back(X_WS * leg.middle_m);
  find_pairs(legs_m_, pairs_m_);
  if (person_) keep_to(sight);
  if (!person_) take_up(sight);
  time_s_ = sight.time_s;
  command_ = person_ ? steer(sight) : DriveCommand{};
  return command_;
}

}  // namespace scanbed::sim
