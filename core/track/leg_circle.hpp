// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"

namespace scanbed {

/// Whether a circle is rather somebody's leg: thin, and found as a leg of at least even odds too.
bool is_leg_too(const Circle& circle, const std::vector<Leg>& legs);

}  // namespace scanbed
