// SPDX-License-Identifier: MIT
#pragma once

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Lengths of a walker's parts, as shares of its leg and its height: what the model is built with, and where
/// its parts are put.
struct WalkerBody {
  explicit WalkerBody(const Walker& walker)
      : hip_m(walker.leg_length_m),
        shank_m(0.53 * walker.leg_length_m),
        thigh_m(walker.leg_length_m - shank_m),
        hip_offset_m(0.052 * walker.height_m),
        shoulder_m(0.81 * walker.height_m),
        head_m(0.93 * walker.height_m) {}

  double hip_m;         ///< hip joint above the floor
  double shank_m;       ///< knee above the foot, with a straight leg
  double thigh_m;       ///< hip above the knee, with a straight leg
  double hip_offset_m;  ///< hip joint to the left or right of the pelvis
  double shoulder_m;    ///< above the floor
  double head_m;        ///< middle of the head above the floor
};

}  // namespace scanbed::sim
