// SPDX-License-Identifier: MIT
#include "scenarios/command/commands.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {

ExitCode execute(const TextCommand& command) {
  write_whole(std::nullopt, command.text);
  return kExitFine;
}

}  // namespace scanbed::scenarios
