// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/output.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/load_scenario.hpp"

namespace scanbed::scenarios {

ExitCode execute(const ValidateCommand& command) {
  std::string text;
  ExitCode code = kExitFine;
  for (const std::string& name_or_path : command.scenarios) {
    // All files are told about, not the first bad one alone.
    try {
      const Scenario scenario = load_scenario(find_scenario(name_or_path));
      text += fmt::format("{}: ok, {}\n", name_or_path, scenario.name);
    } catch (const InputError& error) {
      log_error(error.what());
      code = kExitBadInput;
    }
  }
  write_whole(std::nullopt, text);
  return code;
}

}  // namespace scanbed::scenarios
