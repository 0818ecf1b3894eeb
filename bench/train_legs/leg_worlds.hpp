// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sim/sensor/sensor_options.hpp"
#include "sim/world/world.hpp"

namespace scanbed::bench {

/// A random place with people standing in it: halls, corridors and open floors with furniture, posts, wall
/// stubs and thin things. Legs are solids labelled "leg", "<person>.<0 or 1>", round or oval, apart or
/// touching, in the open or close to furniture; posts that could be legs are labelled "post".
sim::World leg_world(std::uint64_t seed);

/// A laser for that world: one of several steps and spots, with noise, mixed pixels and lost echoes.
sim::SensorOptions leg_sensor(std::uint64_t seed);

}  // namespace scanbed::bench
