// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// What kind of world is drawn.
enum class WorldKind {
  kRooms,      ///< a hall, half of the time parted by a wall with a doorway; columns, posts, boxes, chairs, a
               ///< bench, trash cans, people who stand and walk; the robot stands
  kCorridors,  ///< a long corridor with recessed doors, half of the time crossed by another one; columns,
               ///< trash cans, chairs and people; the robot drives along
};

/// "rooms" and "corridors", in the order of WorldKind.
std::span<const std::string> world_kind_names();

inline constexpr double kRehearsal_s = 30.0;  ///< longer than random_rooms and random_corridors take

/// A new world for each seed, the same for the same one: all but how the laser is tilted. Its height says how
/// thick legs are. It validates.
///
/// @param rehearsal_s  so long nobody runs into anything or anybody, but for what first_collision() passes;
/// 0:
///                     they may from the start.
World random_world(WorldKind kind, std::uint64_t seed, double laser_height_m,
                   double rehearsal_s = kRehearsal_s);

}  // namespace scanbed::sim
