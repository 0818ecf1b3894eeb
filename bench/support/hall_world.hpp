// SPDX-License-Identifier: MIT
#pragma once

#include "sim/world/world.hpp"

namespace scanbed::bench {

/// A hall of 14 x 9 m with columns, square pillars and a walker: about 35 shapes at the laser's height.
sim::World hall_world();

}  // namespace scanbed::bench
