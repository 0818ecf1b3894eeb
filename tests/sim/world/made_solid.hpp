// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/world/world.hpp"

namespace scanbed::testing {

/// From the floor to the ceiling, unless said otherwise.
inline sim::Solid made_solid(const std::string& id, const sim::SolidShape& shape, double bottom_m = 0.0,
                             double top_m = 2.5) {
  return {.id = id, .label = "box", .shape = shape, .bottom_m = bottom_m, .top_m = top_m, .material = {}};
}

}  // namespace scanbed::testing
