// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>

namespace scanbed::test {

/// The slow, independent caster in space: one mj_ray for each beam, on what the laser meets.
class MjReferenceCaster {
 public:
  /// Both must outlive this; mj_kinematics has been called on the data.
  MjReferenceCaster(const mjModel& model, const mjData& data) : model_(model), data_(data) {}

  /// @param direction_W  of length 1. @returns metres; kNoEcho where nothing was met.
  double cast(const Eigen::Vector3d& from_m, const Eigen::Vector3d& direction_W) const;

 private:
  const mjModel& model_;
  const mjData& data_;
};

}  // namespace scanbed::test
