// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace scanbed::scenarios {

// One line each on stderr, "scanbed: error: ..."; control characters in a message become '?'. Coloured only
// on a terminal, and never where NO_COLOR is set to anything but nothing.
void log_error(std::string_view message);
void log_warning(std::string_view message);
void log_note(std::string_view message);

/// The text with '?' in place of control characters: what comes from elsewhere neither breaks a line nor
/// steers a terminal.
std::string one_line(std::string text);

}  // namespace scanbed::scenarios
