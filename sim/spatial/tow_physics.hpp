// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

#include "sim/engine/physics_step.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// Towed cylinders in space: bodies with weight that stand on the floor, rub on it and are pulled by limited
/// tendons. Solids, the robot and the walkers' shanks are in their way. They stay upright, as truth and the
/// planar engine have them.
class TowPhysics {
 public:
  static constexpr double kStep_s = 1.0 / kPhysicsSteps_per_s;

  /// Puts the cylinders of the walkers present in `start` a rope's length behind them. The model stays the
  /// caller's, but ropes of absent walkers are switched off in it.
  /// @pre `model` comes from mjcf_of(world); both outlive this.
  TowPhysics(const World& world, mjModel& model, const WorldState& start);

  /// One step: scripted things reach where `next` has them, a step later than the last.
  /// @throws SensorFault (kSimulator) where the physics diverges.
  void step_to(const WorldState& next);

  /// p_WB of the middle of each underside; far above the world where it is absent.
  std::vector<Eigen::Vector3d> places() const;
  int walker(int tow) const { return pulls_[tow].walker; }

 private:
  struct Pull {
    int walker;
    int tendon;
    int cylinder_qpos, cylinder_qvel;
    int end_qvel;
    double taut_m;
    bool present;
    Eigen::Vector3d end_m;  ///< p_WE of the rope's end at the walker, at the last step
  };

  void appear(int tow, const WalkerState& state);
  void stay_away(int tow);
  void lead(int tow, const WalkerState& next);

  mjModel& model_;
  DataPtr data_;
  ActorPoser poser_;
  std::vector<Pull> pulls_;
};

}  // namespace scanbed::sim
