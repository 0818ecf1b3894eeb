// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/world/collision_watch.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Plays the script of robot and walkers without a laser, up to the first collision that a CollisionWatch
/// sees in looks at equal times: legs that graze each other for a moment may pass. Towed cylinders are left
/// out, and a robot that follows legs stands.
std::optional<Collision> first_collision(const World& world, double duration_s);

}  // namespace scanbed::sim
