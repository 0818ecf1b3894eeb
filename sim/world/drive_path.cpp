// SPDX-License-Identifier: MIT
#include "sim/world/drive_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"
#include "sim/world/world_limits.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kMinRadius_m = 1e-3;  // tighter arcs are turns on the spot
constexpr int kMostPoints = 100'000;

/// A straight way between two points.
struct Stretch {
  double heading_rad = 0.0;
  double length_m = 0.0;
};

// From where the robot stands; rounds are unrolled. Points on which it stands already make no edge.
std::vector<Stretch> stretches_of(const FollowPath& path, const Vector2d& p_WR) {
  std::vector<Stretch> edges;
  Vector2d from_m = p_WR;
  const auto add = [&](const Vector2d& to_m) {
    const Vector2d way_m = to_m - from_m;
    if (way_m.norm() < kMinEdge_m) return;
    edges.push_back({std::atan2(way_m.y(), way_m.x()), way_m.norm()});
    from_m = to_m;
  };
  for (const Vector2d& point : path.points_m) add(point);
  for (int round = 0; round < path.rounds; ++round) {
    // The way to the last point was the first round's; each further one begins at the first point.
    if (round > 0) std::for_each(path.points_m.begin() + 1, path.points_m.end(), add);
    add(path.points_m.front());
  }
  return edges;
}

/// Appends motions that follow each other.
class MotionList {
 public:
  explicit MotionList(const Robot& robot) : robot_(robot) {}

  void turn(double angle_rad) {
    if (angle_rad == 0.0) return;
    const double rate_rad_per_s = std::copysign(robot_.turn_rad_per_s, angle_rad);
    motions_.push_back({angle_rad / rate_rad_per_s, 0.0, rate_rad_per_s});
  }

  void go(double length_m) {
    if (length_m <= 0.0) return;
    motions_.push_back({length_m / robot_.speed_m_per_s, robot_.speed_m_per_s, 0.0});
  }

  void arc(double radius_m, double angle_rad) {
    const double speed_m_per_s = std::min(robot_.speed_m_per_s, radius_m * robot_.turn_rad_per_s);
    motions_.push_back({radius_m * std::abs(angle_rad) / speed_m_per_s, speed_m_per_s,
                        std::copysign(speed_m_per_s / radius_m, angle_rad)});
  }

  std::vector<Motion> take() { return std::move(motions_); }

 private:
  const Robot& robot_;
  std::vector<Motion> motions_;
};

}  // namespace

Pose2 Motion::pose_behind(const Pose2& X_WR, double time_s) const {
  const double turned_rad = time_s * turn_rad_per_s;
  const double half_rad = 0.5 * turned_rad;
  // The chord of an arc, which points halfway between the headings at its ends.
  const double chord_ratio = half_rad == 0.0 ? 1.0 : std::sin(half_rad) / half_rad;
  const Pose2 X_WH{X_WR.p_m, X_WR.theta_rad + half_rad};
  return {X_WR.p_m + time_s * speed_m_per_s * chord_ratio * X_WH.heading(),
          wrap_to_pi(X_WR.theta_rad + turned_rad)};
}

std::vector<Motion> motions_along(const FollowPath& path, const Pose2& X_WR, const Robot& robot) {
  const std::vector<Stretch> edges = stretches_of(path, X_WR.p_m);
  MotionList motions(robot);
  if (edges.empty()) return motions.take();
  const double wanted_m = path.round_m.value_or(robot.speed_m_per_s / robot.turn_rad_per_s);
  motions.turn(wrap_to_pi(edges.front().heading_rad - X_WR.theta_rad));
  double cut_before_m = 0.0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + 1 == edges.size()) {
      motions.go(edges[i].length_m - cut_before_m);
      break;
    }
    const double angle_rad = wrap_to_pi(edges[i + 1].heading_rad - edges[i].heading_rad);
    const double cut_per_radius = std::tan(0.5 * std::abs(angle_rad));
    const double room_m = 0.5 * std::min(edges[i].length_m, edges[i + 1].length_m);
    const double radius_m = std::min(wanted_m, room_m / cut_per_radius);
    const bool is_round = radius_m >= kMinRadius_m && angle_rad != 0.0;
    const double cut_m = is_round ? radius_m * cut_per_radius : 0.0;
    motions.go(edges[i].length_m - cut_before_m - cut_m);
    is_round ? motions.arc(radius_m, angle_rad) : motions.turn(angle_rad);
    cut_before_m = cut_m;
  }
  return motions.take();
}

void validate_path(const FollowPath& path, std::string_view name) {
  const std::string subject = std::string(name) + ": path";
  const auto num_points = static_cast<double>(path.points_m.size());
  require(!path.points_m.empty(), subject + ": number of points", num_points, ">= 1");
  for (std::size_t i = 0; i < path.points_m.size(); ++i) {
    const std::string point = subject + ": point " + std::to_string(i);
    for (const double value : {path.points_m[i].x(), path.points_m[i].y()}) {
      require(std::abs(value) <= kFarthest_m, point, value, "within 1000 m of the origin");
    }
    if (i == 0 && (path.rounds == 0 || path.points_m.size() < 2)) continue;
    const double length_m =
        (path.points_m[i] - (i == 0 ? path.points_m.back() : path.points_m[i - 1])).norm();
    require(length_m >= kMinEdge_m, point + ": distance from the point before", length_m, ">= 0.001 m");
  }
  const double least = path.rounds == 0 ? 1 : 2;
  require(num_points >= least, subject + ": number of points", num_points, ">= 2 to go round");
  require(path.rounds >= 0 && path.rounds * num_points <= kMostPoints, subject + ": rounds", path.rounds,
          "[0, " + std::to_string(kMostPoints / static_cast<int>(num_points)) + "]");
  const double radius_m = path.round_m.value_or(0.0);
  require(radius_m >= 0.0 && radius_m <= kFarthest_m, subject + ": round_m", radius_m, "[0, 1000]");
}

}  // namespace scanbed::sim
