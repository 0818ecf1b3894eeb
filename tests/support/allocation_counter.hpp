// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace scanbed::testing {

/// How often the program has called operator new so far. Link allocation_counter.cpp to have it counted.
std::int64_t num_allocations();

}  // namespace scanbed::testing
