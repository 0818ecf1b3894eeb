// SPDX-License-Identifier: MIT
#pragma once

#include "sim/world/rounded_path.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

inline constexpr double kStanceRatio = 0.6;  ///< of a cycle that a foot stands; it swings for the rest
inline constexpr double kHipWidth_m = 0.20;  ///< between the hip joints

/// Length of one step (left heel to right heel) at a speed: 0.72 m at 1.37 m/s. Slower people take shorter
/// and fewer steps alike: step length over cadence stays as it is.
///
/// @par Source  Normal walking: 0.72 m, 1.37 m/s (see the gait figures of Oeberg 1993). The constant "walk
///              ratio": Sekiya & Nagasaki, "Reproducibility of the walking patterns of normal young adults",
///              Gait & Posture 1998.
double step_length_m(double speed_m_per_s);

/// Time of one gait cycle, two steps: 1.05 s at 1.37 m/s.
double cycle_s(double speed_m_per_s);

/// A walker's pelvis, feet and legs as a function of time.
///
/// The pelvis moves at constant speed. A foot stands for 60 % of the cycle, then moves in a straight line at
/// constant speed to its next footprint, one stride further on; the feet alternate. The leg is rigid from hip
/// to foot: at height h it is at foot + (h / H) (hip - foot). At the start the feet are side by side, left
/// standing and right passing; behind the end of an open path they come to stand side by side.
class Gait {
 public:
  /// @param index     of the walker in World::walkers.
  /// @param height_m  at which WalkerState's legs are; above the hips they are at the hips.
  /// @pre the walker validates.
  Gait(const Walker& walker, int index, double height_m);

  WalkerState state_at(double time_s) const;

 private:
  Eigen::Vector2d foot_m(double walked_s, double side) const;
  Eigen::Vector2d footprint_m(double cycle, double side) const;

  RoundedPath path_;
  int index_;
  double start_s_;
  double speed_m_per_s_;
  double step_width_m_;
  double leg_ratio_;  ///< height at which legs are wanted, over leg length
  bool leaves_;
  bool loop_;
};

}  // namespace scanbed::sim
