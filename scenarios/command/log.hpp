// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace scanbed::scenarios {

// One line each on stderr, "scanbed: error: ..."; control characters in a message become '?'. Coloured only
// on a terminal, and never where NO_COLOR is set to anything but nothing.
void log_error(std::string_view message);
void log_warning(std::string_view message);
void log_note(std::string_view message);

}  // namespace scanbed::scenarios
