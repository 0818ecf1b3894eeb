// SPDX-License-Identifier: MIT
#include <array>
#include <memory>

#include "scenarios/command/commands.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/run/output.hpp"
#include "sim/engine/make_engine.hpp"
#include "sim/spatial/posed_mjcf.hpp"

namespace scanbed::scenarios {
namespace {

struct ExportTexts {
  std::vector<std::string> scenarios;
  std::string mjcf;
  SeedFlag seed;
  SettingFlag settings;
};

}  // namespace

ExitCode execute(const ExportCommand& command) {
  refuse_detector_settings(command.settings);
  const Scenario scenario = open_scenario(command.scenario, command.settings, command.seed);
  scenario.world.validate();
  const auto engine = sim::make_engine(scenario.world, sim::Backend::kPlanar);
  write_whole(command.mjcf, sim::posed_mjcf(scenario.world, engine->state()));
  return kExitFine;
}

Usage export_usage() {
  auto texts = std::make_shared<ExportTexts>();
  Usage usage{.name = "export", .summary = "Write a scenario's world for other programs"};
  usage.flags = {
      one_scenario(texts->scenarios),
      {"--mjcf", "FILE", "MuJoCo's model format; - is standard output", &texts->mjcf, true},
      texts->seed.flag(),
      texts->settings.flag(SettingFlag::Of::kScenario),
  };
  usage.footer =
      R"(What moves stands as the scenario begins: robot and walkers as mocap bodies, which move where they are put,
towed cylinders as free ones; who comes later waits far below the floor.
Example:
  scanbed export static_hallway --mjcf hall.xml)";
  usage.command = [texts] {
    check_files(std::array{FlagFile{"--mjcf", to_path(texts->mjcf)}}, scenario_files(texts->scenarios));
    return ExportCommand{.scenario = texts->scenarios.front(),
                         .mjcf = texts->mjcf,
                         .seed = texts->seed.value(),
                         .settings = texts->settings.values()};
  };
  return usage;
}

}  // namespace scanbed::scenarios
