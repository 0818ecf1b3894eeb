// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace scanbed::scenarios {

/// Appends formatted text. By way of a string of its own, as fmt::format_to would be compiled anew in every
/// source that calls it, which takes seconds.
template <typename... Arguments>
void append_format(std::string& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  out += fmt::format(format, std::forward<Arguments>(arguments)...);
}

}  // namespace scanbed::scenarios
