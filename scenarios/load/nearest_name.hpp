// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scanbed::scenarios {

/// How many letters must be inserted, dropped, changed or swapped with their neighbour to turn a into b.
///
/// @par Cost    O(|a| |b|).
/// @par Source  Optimal string alignment distance (Damerau 1964's four errors, no substring edited twice).
int edit_distance(std::string_view a, std::string_view b);

/// The known name that `word` was probably meant to be; none where all are farther than a third of its
/// letters. Of several equally near, the first.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> known);

/// "; did you mean 'radius'?"; empty where no name is near.
std::string near_name_hint(std::string_view word, std::span<const std::string> known);

/// The same or, where no name is near, "; known keys: at, r" (with `what` in place of
/// "keys").
std::string name_hint(std::string_view word, std::span<const std::string> known, std::string_view what);

}  // namespace scanbed::scenarios
