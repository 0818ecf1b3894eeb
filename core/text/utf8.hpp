// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scanbed {

/// Length of the character that a text of UTF-8 begins with, 1 to 4 bytes; 0 where it begins with none.
/// @par Source  RFC 3629, section 4.
std::size_t utf8_length(std::string_view text);

/// The text with U+FFFD in place of each byte that is not part of a character.
std::string as_utf8(std::string_view text);

}  // namespace scanbed
