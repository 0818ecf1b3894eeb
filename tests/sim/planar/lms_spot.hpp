// SPDX-License-Identifier: MIT
#pragma once

#include "sim/planar/spot_caster.hpp"

namespace scanbed::testing {

/// The beam of a SICK LMS 200.
inline constexpr sim::Spot kLmsSpot{.diameter_m = 0.014, .divergence_rad = 0.0044, .num_rays = 7};

}  // namespace scanbed::testing
