// SPDX-License-Identifier: MIT
#pragma once

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Whether things are where they can be, taken together: each of them is known to be well formed.
///
/// @throws InputError naming the first thing that has no room: a solid that nobody can see because it lies
///         wholly within another one that is filled (touching its outline or not; walls have no inside), a
///         robot, walker or towed cylinder that starts in a solid, a robot or walker in what a map fills, a
///         walker whose path leads into a solid, a robot outside the closed walls around everything else.
/// @par Cost  O(solids^2) comparisons of bounds.
void check_places(const World& world);

}  // namespace scanbed::sim
