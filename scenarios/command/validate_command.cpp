// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/usage.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "scenarios/run/output.hpp"

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

Usage validate_usage() {
  auto command = std::make_shared<ValidateCommand>();
  Usage usage{.name = "validate", .summary = "Check scenario files without running them"};
  usage.flags = {{"FILE", "", "YAML files or names of the library", &command->scenarios, true}};
  usage.footer = R"(Example:
  scanbed validate my_hall.yaml static_hallway)";
  usage.command = [command] { return *command; };
  return usage;
}

}  // namespace scanbed::scenarios
