// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scenarios/load/asked.hpp"

namespace scanbed::scenarios {

/// The JSON Schema (draft 2020-12) of scenario files, drawn from what the loader asks of them: keys, types,
/// words, ranges, numbers of elements, keys that must be there. A number may also be arithmetic, a text.
/// Files that include others may leave out any key.
///
/// It says less than the loader checks: keys that exclude each other, values that must fit together.
std::string json_schema(const Asked& scenario);

}  // namespace scanbed::scenarios
