// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"

namespace scanbed {

/// Non-maximum suppression: keeps the leg of the highest score, drops what is one with it, and so on. Two are
/// one if they share a beam or if their middles lie within 0.10 m. Leaves the best one first.
void keep_best_legs(std::vector<Leg>& legs);

}  // namespace scanbed
