// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/track/live_track.hpp"

namespace scanbed {

inline constexpr double kOneLegSigma_m = 0.18;    ///< of one leg, about the person's middle
inline constexpr double kBothLegsSigma_m = 0.04;  ///< of their middle, about the person's

/// Of a distance from where something is expected: -2 times the log-likelihood, but for a constant that makes
/// it 0 for one leg at the middle of a person who is exactly known.
double surprise_of_place(double distance_m2, double var_m2);

/// Where the legs of somebody are expected in a scan. Of one who walks one foot stands while the other
/// swings: by the scan before, that leg is known far better than the person's middle alone would tell. Both
/// legs lie about the middle, along the way rather than across it, and none goes faster than a swing.
///
/// Surprises are those of surprise_of_place(), a constant for each leg.
///
/// @par Source  A foot stands for 60 % of a cycle: Perry, "Gait Analysis: Normal and Pathological Function",
///              1992. With a rigid leg a shin is at foot + 0.3 (hip - foot): it goes at 0.3 of the person's
///              speed where the foot stands, and at 2.05 of it where it swings. Departs: 0.35 where it
///              stands, and a spread about that.
class GaitExpectation {
 public:
  /// @param person  predicted to the scan's time.
  explicit GaitExpectation(const LiveTrack& person);

  double surprise_of(const Eigen::Vector2d& p_WL_m) const;
  double surprise_of(const Eigen::Vector2d& p_WA_m, const Eigen::Vector2d& p_WB_m) const;

 private:
  double standing_likelihood(const Eigen::Vector2d& p_WL_m) const;
  double haste(const Eigen::Vector2d& p_WA_m, const Eigen::Vector2d& p_WB_m) const;

  Eigen::Vector2d middle_m_;
  double middle_var_m2_;
  std::array<Eigen::Vector2d, 2> last_m_;      ///< legs, when last seen
  std::array<Eigen::Vector2d, 2> standing_m_;  ///< and by now, where the foot stands
  int num_legs_;
  double standing_var_m2_;
  double reach_m_;         ///< of a leg that swings, since
  double standing_ratio_;  ///< how likely it is that a foot stood since they were seen
  Eigen::Vector2d along_;
  double across_var_m2_;
};

}  // namespace scanbed
