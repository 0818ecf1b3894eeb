// SPDX-License-Identifier: MIT
#include "core/track/gait_expectation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {
namespace {

constexpr double kAlongSigma_m = 0.38;     // from one leg to the other, along the way
constexpr double kAcrossSigma_m = 0.20;    // ... and across it
constexpr double kStandingSigma_m = 0.03;  // of a leg whose foot stands
constexpr double kShinSpeedRatio = 0.35;   // of it, to the person's
constexpr double kShinSpeedSpread = 0.12;
constexpr double kSwingSpeedRatio = 2.05;    // of a shin that swings, to the person's speed
constexpr double kSwingReach_m = 0.1;        // of a leg beyond that
constexpr double kKnownSpeed_m_per_s = 0.8;  // standard deviation; above, any reach is possible
constexpr double kLegReachSigma_m = 0.1;
constexpr double kMaxHaste = 8.0;
constexpr double kStanding_s = 0.63;   // of one foot in a cycle ...
constexpr double kCycle_s = 1.05;      // ... of two steps
constexpr double kSlow_m_per_s = 0.3;  // at which legs lie in any direction

constexpr double kUnit_m2 = kOneLegSigma_m * kOneLegSigma_m;

// Likelihood of a distance, in units of that of a leg at its most likely place.
double gaussian(double distance_m2, double var_m2) {
  return kUnit_m2 / var_m2 * std::exp(-0.5 * distance_m2 / var_m2);
}

// That a leg went farther than its reach; bounded, as people start and turn.
double surprise_of_haste(double way_m, double reach_m) {
  const double beyond = std::max(0.0, way_m - reach_m) / kLegReachSigma_m;
  return std::min(kMaxHaste, beyond * beyond);
}

// That at least one foot stood all the time since: each does for a part of the cycle, in turn.
double standing_ratio(double unseen_s) {
  return std::clamp(2.0 * (kStanding_s - unseen_s) / kCycle_s, 0.0, 0.95);
}

}  // namespace

double surprise_of_place(double distance_m2, double var_m2) {
  return distance_m2 / var_m2 + 2.0 * std::log(var_m2 / kUnit_m2);
}

GaitExpectation::GaitExpectation(const LiveTrack& person)
    : middle_m_(person.point.p_m),
      middle_var_m2_(person.point.var_p_m2),
      num_legs_(person.num_legs_seen),
      standing_ratio_(person.num_legs_seen == 0 ? 0.0 : standing_ratio(person.unseen_s)) {
  const double speed_m_per_s = person.point.v_m_per_s.norm();
  const double way_m = speed_m_per_s * person.unseen_s;
  last_m_ = person.p_WL_m;
  const bool knows_speed = person.point.var_v_m2_per_s2 < kKnownSpeed_m_per_s * kKnownSpeed_m_per_s;
  reach_m_ = knows_speed ? kSwingReach_m + kSwingSpeedRatio * way_m : std::numeric_limits<double>::infinity();
  for (int i = 0; i < num_legs_; ++i)
    standing_m_[i] = person.p_WL_m[i] + kShinSpeedRatio * person.unseen_s * person.point.v_m_per_s;
  const double spread_m = kShinSpeedSpread * way_m;
  standing_var_m2_ = kStandingSigma_m * kStandingSigma_m + spread_m * spread_m;
  along_ = speed_m_per_s > 0.0 ? Eigen::Vector2d(person.point.v_m_per_s / speed_m_per_s)
                               : Eigen::Vector2d(1.0, 0.0);
  const double speed2 = speed_m_per_s * speed_m_per_s;
  const double sureness = speed2 / (speed2 + person.point.var_v_m2_per_s2 + kSlow_m_per_s * kSlow_m_per_s);
  across_var_m2_ =
      sureness * kAcrossSigma_m * kAcrossSigma_m + (1.0 - sureness) * kAlongSigma_m * kAlongSigma_m;
}

double GaitExpectation::standing_likelihood(const Eigen::Vector2d& p_WL_m) const {
  double likelihood = 0.0;
  for (int i = 0; i < num_legs_; ++i)
    likelihood = std::max(likelihood, gaussian((p_WL_m - standing_m_[i]).squaredNorm(), standing_var_m2_));
  return likelihood;
}

// Of both legs, in the order that suits them better.
double GaitExpectation::haste(const Eigen::Vector2d& p_WA_m, const Eigen::Vector2d& p_WB_m) const {
  if (num_legs_ < 2) return 0.0;
  const auto of = [&](const Eigen::Vector2d& first_m, const Eigen::Vector2d& second_m) {
    return surprise_of_haste((first_m - last_m_[0]).norm(), reach_m_) +
           surprise_of_haste((second_m - last_m_[1]).norm(), reach_m_);
  };
  return std::min(of(p_WA_m, p_WB_m), of(p_WB_m, p_WA_m));
}

double GaitExpectation::surprise_of(const Eigen::Vector2d& p_WL_m) const {
  const double about_middle = gaussian((p_WL_m - middle_m_).squaredNorm(), middle_var_m2_ + kUnit_m2);
  const double share = 0.5 * standing_ratio_;
  return -2.0 * std::log(share * standing_likelihood(p_WL_m) + (1.0 - share) * about_middle + 1e-12);
}

double GaitExpectation::surprise_of(const Eigen::Vector2d& p_WA_m, const Eigen::Vector2d& p_WB_m) const {
  const double of_middle = surprise_of_place((0.5 * (p_WA_m + p_WB_m) - middle_m_).squaredNorm(),
                                             middle_var_m2_ + kBothLegsSigma_m * kBothLegsSigma_m);
  const Eigen::Vector2d apart_m = p_WB_m - p_WA_m;
  const double along_m = apart_m.dot(along_);
  const double across2 = std::max(0.0, apart_m.squaredNorm() - along_m * along_m);
  const double apart = along_m * along_m / (kAlongSigma_m * kAlongSigma_m) + across2 / across_var_m2_ +
                       std::log(kAlongSigma_m * kAlongSigma_m * across_var_m2_ / (kUnit_m2 * kUnit_m2));
  const double standing = std::max(standing_likelihood(p_WA_m), standing_likelihood(p_WB_m));
  return of_middle + apart + haste(p_WA_m, p_WB_m) -
         2.0 * std::log(standing_ratio_ * standing + 1.0 - standing_ratio_);
}

}  // namespace scanbed
