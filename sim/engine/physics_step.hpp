// SPDX-License-Identifier: MIT
#pragma once

namespace scanbed::sim {

/// Both engines move what is towed in steps of this rate, from time 0 on.
inline constexpr double kPhysicsSteps_per_s = 300.0;

}  // namespace scanbed::sim
