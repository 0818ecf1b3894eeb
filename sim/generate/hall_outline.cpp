// SPDX-License-Identifier: MIT
#include "sim/generate/hall_outline.hpp"

#include <vector>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

/// From one corner of the hall to the next, counter-clockwise.
struct Side {
  Vector2d from_m;
  Vector2d to_m;
};

// All corners of a side but its last.
void add_side(const Side& side, const WallNiches& niches, WorldDice& dice, std::vector<Vector2d>& corners_m) {
  const double length_m = (side.to_m - side.from_m).norm();
  const Vector2d along = (side.to_m - side.from_m).normalized();
  const Vector2d outwards(along.y(), -along.x());
  corners_m.push_back(side.from_m);
  double at_m = niches.first.draw(dice);
  for (; at_m + niches.last_m < length_m; at_m += niches.next.draw(dice)) {
    if (!dice.chance(niches.chance)) continue;
    const double width_m = niches.width.draw(dice);
    const Vector2d step_m = niches.depth.draw(dice) * outwards;
    const Vector2d from_m = side.from_m + at_m * along;
    const Vector2d to_m = from_m + width_m * along;
    for (const Vector2d& c_m : {from_m, Vector2d(from_m + step_m), Vector2d(to_m + step_m), to_m}) {
      corners_m.push_back(c_m);
    }
  }
}

}  // namespace

WallChain hall_outline(const Vector2d& half_m, const WallNiches& niches, WorldDice& dice) {
  const Vector2d corners_m[] = {-half_m, {half_m.x(), -half_m.y()}, half_m, {-half_m.x(), half_m.y()}};
  WallChain chain{{}, true};
  for (int i = 0; i < 4; ++i) {
    add_side({corners_m[i], corners_m[(i + 1) % 4]}, niches, dice, chain.corners_m);
  }
  return chain;
}

}  // namespace scanbed::sim
