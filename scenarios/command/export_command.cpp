// SPDX-License-Identifier: MIT
#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/output.hpp"
#include "sim/spatial/mjcf.hpp"

namespace scanbed::scenarios {

ExitCode execute(const ExportCommand& command) {
  const SortedSettings settings = sort_settings(command.settings);
  if (!settings.detector.empty()) {
    throw InputError("--set " + settings.detector[0].path +
                     ": a world has no detector; allowed: the scenario's values");
  }
  const Scenario scenario = open_scenario(command.scenario, settings.scenario, command.seed);
  scenario.world.validate();
  write_whole(command.mjcf, sim::mjcf_of(scenario.world));
  return kExitFine;
}

}  // namespace scanbed::scenarios
