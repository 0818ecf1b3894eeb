// SPDX-License-Identifier: MIT
#include "sim/world/crowd.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kAsideReach_m = 1.5;
constexpr double kMostAside_m = 0.45;
constexpr double kEarSide_m = 0.3;  // who is less than this to the right is passed on the right as well
constexpr double kSameWay_m2_per_s2 = 0.25;  // slower relative motion is that of companions
constexpr double kHalfSecond_s = 0.5;

Vector2d velocity_m_per_s(const Gait& gait, double time_s) {
  return gait.pose_at(time_s + kHalfSecond_s).p_m - gait.pose_at(time_s - kHalfSecond_s).p_m;
}

}  // namespace

double SideStep::to_the_left_m(double time_s) const {
  const Gait& self = (*all_)[self_];
  const Pose2 X_WP = self.pose_at(time_s);
  double aside_m = 0.0;
  for (std::size_t i = 0; i < all_->size(); ++i) {
    const Gait& other = (*all_)[i];
    if (static_cast<int>(i) == self_) continue;
    const Vector2d p_WO = other.pose_at(time_s).p_m;
    const double near = 1.0 - (p_WO - X_WP.p_m).squaredNorm() / (kAsideReach_m * kAsideReach_m);
    if (near <= 0.0) continue;
    const Vector2d p_PO = X_WP.inverse() * p_WO;
    const double apart_sq = (velocity_m_per_s(self, time_s) - velocity_m_per_s(other, time_s)).squaredNorm();
    const double side = (p_PO.y() + kEarSide_m) / kEarSide_m;
    aside_m -= other.presence(time_s) * near * near * apart_sq / (apart_sq + kSameWay_m2_per_s2) *
               kMostAside_m * side / std::sqrt(1.0 + side * side);
  }
  return std::clamp(aside_m, -kMostAside_m, kMostAside_m);
}

Crowd::Crowd(const World& world, double height_m) {
  for (std::size_t i = 0; i < world.walkers.size(); ++i) {
    gaits_.emplace_back(world.walkers[i], static_cast<int>(i), height_m);
    avoids_.push_back(world.walkers[i].avoids);
  }
}

void Crowd::states_at(double time_s, std::vector<WalkerState>& states) const {
  states.resize(gaits_.size());
  for (std::size_t i = 0; i < gaits_.size(); ++i) {
    const SideStep aside(gaits_, static_cast<int>(i));
    states[i] = gaits_[i].state_at(time_s, avoids_[i] ? &aside : nullptr);
  }
}

}  // namespace scanbed::sim
