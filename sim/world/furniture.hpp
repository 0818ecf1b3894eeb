// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Two short cylinders that carry a seat; the laser usually looks below the seat.
struct Bench {
  std::string id;
  std::string label = "bench";
  Pose2 X_WB;  ///< of the seat's middle, x axis from foot to foot
  double foot_radius_m = 0.25;
  double feet_apart_m = 1.2;  ///< between their axes
  double seat_height_m = 0.45;
};

/// A square seat on four thin square legs, between which the laser looks through.
struct Chair {
  std::string id;
  std::string label = "chair";
  Pose2 X_WC;  ///< of the seat's middle
  double size_m = 0.42;
  double leg_m = 0.03;  ///< width of a leg
  double seat_height_m = 0.45;
};

/// "<id>.foot_0", "<id>.foot_1" and "<id>.seat".
std::vector<Solid> bench_parts(const Bench& bench);

/// "<id>.leg_0" to "<id>.leg_3", counter-clockwise from the corner behind on the right, and "<id>.seat".
std::vector<Solid> chair_parts(const Chair& chair);

}  // namespace scanbed::sim
