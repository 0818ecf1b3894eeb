// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/command/commands.hpp"
#include "scenarios/load/scenario.hpp"
#include "scenarios/run/run_scenario.hpp"

namespace scanbed::scenarios {

/// One scenario with one seed.
struct Run {
  std::string name;  ///< or path, as it was asked for
  const Scenario& scenario;
  const Processing& processing;
  std::optional<std::filesystem::path> out;  ///< folder for its pictures
  bool shows_progress = false;               ///< on stderr
};

struct RunAndPictures {
  RunResult result;
  std::vector<std::filesystem::path> pictures;
};

/// Runs a scenario on the command's laser; several at the same time, where that is simulated.
///
/// @throws InputError, SensorFault, OutputFault.
RunAndPictures run_one(const RunCommand& command, const Run& run);

}  // namespace scanbed::scenarios
