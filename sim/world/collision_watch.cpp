// SPDX-License-Identifier: MIT
#include "sim/world/collision_watch.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kSameMeeting_s = 1.0;
constexpr int kRobot = 0;
// A rope stretched by so much pulls at a cylinder that something holds; what it then touches does.
constexpr double kStuck_m = 0.15;
constexpr double kTouches_m = 0.05;  // where walls have their thickness, too
// By so much, soft contacts let a cylinder into what it only rubs along.
constexpr double kRubs_m = 0.03;

bool overlap(const Vector2d& a_m, const Vector2d& b_m, double radii_m) {
  return (a_m - b_m).squaredNorm() < radii_m * radii_m;
}

bool overlap(const ShapeOutline& outline, const Vector2d& center_m, double radius_m) {
  if (outline.bounds().squaredExteriorDistance(center_m) >= radius_m * radius_m) return false;
  return outline.clearance_m(center_m) < radius_m;
}

std::array<Vector2d, 2> legs_of(const WalkerState& walker) {
  return {walker.left_leg_m, walker.right_leg_m};
}

bool do_legs_overlap(const WalkerState& a, const WalkerState& b, double radii_m) {
  for (const Vector2d& leg_m : legs_of(a)) {
    for (const Vector2d& its_m : legs_of(b)) {
      if (overlap(leg_m, its_m, radii_m)) return true;
    }
  }
  return false;
}

}  // namespace

std::string to_string(const Collision& collision) {
  std::array<char, 32> time{};
  std::snprintf(time.data(), time.size(), "at %.2f s ", collision.time_s);
  return time.data() + collision.first + " runs into " + collision.second;
}

CollisionWatch::CollisionWatch(const World& world) : robot_radius_m_(world.robot.radius_m) {
  names_.emplace_back("robot");
  for (const Walker& walker : world.walkers) {
    names_.push_back(walker.id);
    leg_radius_m_.push_back(walker.leg_radius_m);
  }
  for (const Walker& walker : world.walkers) {
    names_.push_back(walker.tow ? walker.tow->id : "");
    tows_.push_back(walker.tow.value_or(Tow{}));
  }
  const double laser_height_m = world.robot.laser_height_m;
  for (const Solid& solid : world.solids) {
    const bool stops_robot = solid.bottom_m < laser_height_m && solid.top_m > 0.0;
    obstacles_.push_back({static_cast<int>(names_.size()), ShapeOutline(solid.shape), stops_robot,
                          is_at_height(solid, laser_height_m), solid.bottom_m, solid.top_m});
    names_.push_back(solid.id);
  }
}

void CollisionWatch::meet(int first, int second) {
  const auto known = std::find_if(meetings_.begin(), meetings_.end(), [&](const Meeting& meeting) {
    return meeting.first == first && meeting.second == second;
  });
  if (known == meetings_.end()) {
    meetings_.push_back({first, second, time_s_});
  } else {
    const bool goes_on = time_s_ - known->last_s < kSameMeeting_s;
    known->last_s = time_s_;
    if (goes_on) return;
  }
  collisions_.push_back({time_s_, names_[first], names_[second]});
}

void CollisionWatch::look_at_robot(const WorldState& state) {
  const Vector2d& center_m = state.X_WR.p_m;
  for (const Obstacle& obstacle : obstacles_) {
    if (obstacle.stops_robot && overlap(obstacle.outline, center_m, robot_radius_m_)) {
      meet(kRobot, obstacle.thing);
    }
  }
  for (const TowState& tow : state.tows) {
    if (tow.present && overlap(center_m, tow.center_m, robot_radius_m_ + tows_[tow.walker].radius_m)) {
      meet(kRobot, thing_of(tow));
    }
  }
}

int CollisionWatch::thing_of(const TowState& tow) const {
  return 1 + static_cast<int>(tows_.size()) + tow.walker;
}

// The planar engine holds a cylinder that the script pulls into something, the spatial one may pull it
// through.
void CollisionWatch::look_at_tow(const TowState& tow, const WalkerState& walker) {
  const Tow& what = tows_[tow.walker];
  const double pulled_m = (walker.X_WP.p_m - tow.center_m).norm() - what.taut_m();
  const double reach_m = what.radius_m + (pulled_m > kStuck_m ? kTouches_m : -kRubs_m);
  for (const Obstacle& obstacle : obstacles_) {
    const bool is_in_the_way = obstacle.bottom_m < what.height_m && obstacle.top_m > 0.0;
    if (is_in_the_way && overlap(obstacle.outline, tow.center_m, reach_m))
      meet(thing_of(tow), obstacle.thing);
  }
}

void CollisionWatch::look_at_legs(const WorldState& state, std::size_t walker) {
  const int self = 1 + static_cast<int>(walker);
  for (const Vector2d& leg_m : legs_of(state.walkers[walker])) {
    const double radius_m = leg_radius_m_[walker];
    if (overlap(leg_m, state.X_WR.p_m, radius_m + robot_radius_m_)) meet(kRobot, self);
    for (const Obstacle& obstacle : obstacles_) {
      if (obstacle.stops_legs && overlap(obstacle.outline, leg_m, radius_m)) meet(self, obstacle.thing);
    }
  }
  for (std::size_t other = walker + 1; other < state.walkers.size(); ++other) {
    const double radii_m = leg_radius_m_[walker] + leg_radius_m_[other];
    if (state.walkers[other].present &&
        do_legs_overlap(state.walkers[walker], state.walkers[other], radii_m)) {
      meet(self, 1 + static_cast<int>(other));
    }
  }
}

void CollisionWatch::look(const WorldState& state) {
  time_s_ = state.time_s;
  look_at_robot(state);
  for (std::size_t i = 0; i < state.walkers.size(); ++i) {
    if (state.walkers[i].present) look_at_legs(state, i);
  }
  for (const TowState& tow : state.tows) {
    if (tow.present) look_at_tow(tow, state.walkers[tow.walker]);
  }
}

}  // namespace scanbed::sim
