// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <vector>

#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// Where the parts of an actor go that is not in the world: below the floor, out of every picture.
inline constexpr double kAbsent_m = -1000.0;

/// Puts robot, walkers, towed cylinders and ropes of a model where a state says.
class ActorPoser {
 public:
  /// @pre `model` comes from mjcf_of(world). Checked; aborts.
  ActorPoser(const World& world, const mjModel& model);

  /// Writes mocap poses and joint positions; actors that `state` does not name, or that are not present, go
  /// to z = kAbsent_m. What follows from them is not computed (see pose_actors).
  void put(const WorldState& state, mjData& data) const;

  /// Only what is scripted, without the towed cylinders and ropes: for physics.
  void put_scripted(const WorldState& state, mjData& data) const;

  /// Tow i of WorldState::tows alone. @param p_WB  the middle of its underside.
  void put_tow(int tow, const Eigen::Vector3d& p_WB, mjData& data) const;

  /// Where the rope of tow i ends at its walker, or out of sight.
  void put_rope_end(int tow, const Eigen::Vector3d& p_WE, mjData& data) const;
  double rope_height_m(int tow) const { return tows_[tow].rope_height_m; }

 private:
  struct Leg {
    int foot, shank, thigh;  ///< mocap ids
  };
  struct Person {
    int torso;
    Leg left, right;
  };
  struct Pull {
    int walker;
    int cylinder_qpos, end_qpos;
    double rope_height_m;
  };
  struct LegPoints {
    Eigen::Vector2d foot_m, at_laser_m;
    double side;
  };

  void put_mocap(int mocap, const Eigen::Isometry3d& X_WB, mjData& data) const;
  void put_leg(const WalkerState& state, const Leg& leg, const LegPoints& points, mjData& data) const;

  const World& world_;
  const mjModel& model_;
  int robot_;
  std::vector<Person> people_;
  std::vector<Pull> tows_;
};

/// ActorPoser::put, and then the poses that follow (mj_kinematics, tendons): all that a picture needs.
///
/// @pre `model` comes from mjcf_of(world), `data` from make_data(model). Checked; aborts.
void pose_actors(const World& world, const WorldState& state, const mjModel& model, mjData& data);

}  // namespace scanbed::sim
