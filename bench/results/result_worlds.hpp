// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sim/world/world.hpp"

namespace scanbed::bench {

/// What a set of random worlds is to ask of a detector.
enum class WorldSet {
  kRooms,      ///< columns of 0.04 to 1 m radius, boxes and standing people between walls with niches
  kCorridors,  ///< long walls with door niches, seen at grazing incidence
  kCut,        ///< columns partly behind columns, posts, boxes and wall stubs
  kConfusers,  ///< columns among square posts, V corners, chairs of four thin legs and wall stubs
};

inline constexpr WorldSet kWorldSets[] = {WorldSet::kRooms, WorldSet::kCorridors, WorldSet::kCut,
                                          WorldSet::kConfusers};

const char* name_of(WorldSet set);

/// The world of a set for a seed, with the robot somewhere in it. Everything stands still.
sim::World result_world(WorldSet set, std::uint64_t seed);

}  // namespace scanbed::bench
