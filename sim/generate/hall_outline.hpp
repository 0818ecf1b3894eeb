// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "sim/generate/world_dice.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// From the least to the greatest.
struct LengthRange {
  double least_m = 0.0;
  double greatest_m = 0.0;

  double draw(WorldDice& dice) const { return dice.uniform(least_m, greatest_m); }
};

/// Niches along a wall, each somewhere within its span.
struct WallNiches {
  double chance = 0.0;  ///< of each place for a niche to have one
  LengthRange first;    ///< place, from the wall's beginning
  LengthRange next;     ///< place, from the one before
  double last_m = 0.0;  ///< no place nearer than this to the wall's end
  LengthRange width;    ///< along the wall
  LengthRange depth;    ///< outwards; negative: a projection
};

/// The outline of a rectangular hall about the origin, |x| <= half.x and |y| <= half.y but for its niches.
///
/// Draws for each wall, in this order: the first place; at each place whether there is a niche, then its
/// width and depth, and the distance of the next place.
WallChain hall_outline(const Eigen::Vector2d& half_m, const WallNiches& niches, WorldDice& dice);

}  // namespace scanbed::sim
