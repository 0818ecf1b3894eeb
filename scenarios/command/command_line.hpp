// SPDX-License-Identifier: MIT
#pragma once

#include "scenarios/command/commands.hpp"

namespace scanbed::scenarios {

/// What the arguments ask for. `--help`, `help` and `--version` come back as a TextCommand.
///
/// @throws InputError for wrong usage: what is wrong, and where the help is.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace scanbed::scenarios
