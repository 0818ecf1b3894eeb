// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/world/rounded_path.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

class SideStep;

inline constexpr double kStanceRatio = 0.6;  ///< of a cycle that a foot stands; it swings for the rest
inline constexpr double kHipWidth_m = 0.20;  ///< between the hip joints
inline constexpr double kTurnOnTheSpot_rad_per_s = 1.5;

/// Length of one step (left heel to right heel) at a speed: 0.72 m at 1.37 m/s. Slower people take shorter
/// and fewer steps alike: step length over cadence stays as it is.
///
/// @par Source  Normal walking: 0.72 m, 1.37 m/s (see the gait figures of Oeberg 1993). The constant "walk
///              ratio": Sekiya & Nagasaki, "Reproducibility of the walking patterns of normal young adults",
///              Gait & Posture 1998.
double step_length_m(double speed_m_per_s);

/// Time of one gait cycle, two steps: 1.05 s at 1.37 m/s.
double cycle_s(double speed_m_per_s);

/// The shortest time that a walker can stop for: one cycle to bring its feet side by side, then there and
/// back again for a turn on the spot.
double shortest_stop_s(double speed_m_per_s, double turn_rad);

/// A walker's pelvis, feet and legs as a function of time.
///
/// The pelvis moves at constant speed, but for stops. A foot stands for 60 % of the cycle, then moves in a
/// straight line at constant speed to its next footprint, one stride further on; the feet alternate. The leg
/// is rigid from hip to foot: at height h it is at foot + (h / H) (hip - foot). At the start and after a stop
/// the feet are side by side, left standing and right passing; at a stop and behind the end of an open path
/// they come to stand side by side.
class Gait {
 public:
  /// @param index     of the walker in World::walkers.
  /// @param height_m  at which WalkerState's legs are; above the hips they are at the hips.
  /// @pre the walker validates.
  Gait(const Walker& walker, int index, double height_m);

  /// @param aside  how the walker gives way to others; nullptr: not at all.
  WalkerState state_at(double time_s, const SideStep* aside = nullptr) const;

  /// Pelvis on its path, as if nobody else were there.
  Pose2 pose_at(double time_s) const;

  /// 1 while the walker is in the world, 0 while it is not, linear in the second behind its start and before
  /// it leaves.
  double presence(double time_s) const;

 private:
  /// Walking without a rest, then standing.
  struct Stretch {
    double start_s;
    double from_m;  ///< along the path
    double to_m;    ///< where it ends; infinite on a loop without another stop
    double turn_rad;
    double behind_s;  ///< when the next one starts
  };
  /// A moment of a stretch.
  struct Moment {
    const Stretch& stretch;
    double time_s;
    const SideStep* aside;
    double arrival_s;  ///< at the end of the stretch
  };

  Moment moment(double time_s, const SideStep* aside) const;
  Pose2 pose(const Moment& now) const;
  double turned_rad(const Moment& now) const;
  Eigen::Vector2d foot_m(const Moment& now, double side) const;
  Eigen::Vector2d footprint_m(const Moment& now, double cycle, double side) const;

  RoundedPath path_;
  std::vector<Stretch> stretches_;
  int index_;
  double start_s_;
  double leave_s_;  ///< when it vanishes; infinite if never
  double speed_m_per_s_;
  double step_width_m_;
  double lateral_m_;
  double leg_ratio_;  ///< height at which legs are wanted, over leg length
};

}  // namespace scanbed::sim
