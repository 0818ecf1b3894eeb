// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/truth.hpp"
#include "core/score/match_options.hpp"
#include "core/score/tally.hpp"

namespace scanbed {

/// Compares the circles of one scan with its true cylinders, one to one and nearest first. A circle on a true
/// leg, or on a cylinder that need not be found, is neither right nor wrong.
KindScore match_circles(const std::vector<Circle>& circles, const Truth& truth, const MatchOptions& options);

/// The same for legs. A leg on a true cylinder narrower than options.narrow_cylinder_m is neither right nor
/// wrong.
KindScore match_legs(const std::vector<Leg>& legs, const Truth& truth, const MatchOptions& options);

}  // namespace scanbed
