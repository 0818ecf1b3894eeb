// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/usage.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {

ExitCode execute(const ListCommand&) {
  const std::filesystem::path folder = library_folder();
  std::string text;
  ExitCode code = kExitFine;
  for (const std::string& name : library_names(folder)) {
    // One bad file must not hide the others.
    try {
      const Scenario scenario = load_scenario(folder / (name + ".yaml"));
      text += fmt::format("{:<24}{}\n", name, scenario.description);
    } catch (const InputError& error) {
      log_error(error.what());
      code = kExitBadInput;
    }
  }
  write_whole(std::nullopt, text);
  return code;
}

Usage list_usage() {
  return {.name = "list", .summary = "List the scenarios of the library", .command = [] {
            return ListCommand{};
          }};
}

}  // namespace scanbed::scenarios
