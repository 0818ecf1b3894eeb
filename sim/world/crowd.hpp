// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/world/gait.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// How far one of several walkers steps aside for the others: a function of time alone.
///
/// It looks at where the others would be without giving way. One within 1.5 m that moves otherwise than the
/// walker itself is passed on the side where it is not, one that comes head-on on the right; companions are
/// no obstacle. Simple, not a model of people: in a dense crowd walkers may still touch.
class SideStep {
 public:
  /// @param all  outlives this.
  SideStep(const std::vector<Gait>& all, int self) : all_(&all), self_(self) {}

  double to_the_left_m(double time_s) const;

 private:
  const std::vector<Gait>* all_;
  int self_;
};

/// All walkers of a world.
class Crowd {
 public:
  /// @param height_m  at which WalkerState's legs are.
  /// @pre the world validates.
  Crowd(const World& world, double height_m);

  /// Writes the walkers' states over `states`; allocates nothing once it has the size.
  void states_at(double time_s, std::vector<WalkerState>& states) const;

 private:
  std::vector<Gait> gaits_;
  std::vector<bool> avoids_;
};

}  // namespace scanbed::sim
