// SPDX-License-Identifier: MIT
#include <memory>

#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/command/usage.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {

ExitCode execute(const OptionsCommand& command) {
  for (const Setting& setting : command.settings) {
    if (is_detector_setting(setting.path)) continue;
    throw InputError("--set " + setting.path + ": no such option" + near_detector_setting_hint(setting.path) +
                     "; 'scanbed options' lists them");
  }
  // Warns of what nothing reads: that is not printed either.
  open_detector(command.detector, command.settings, {});
  write_whole(std::nullopt, options_yaml(command.detector, command.settings));
  return kExitFine;
}

Usage options_usage() {
  struct Texts {
    DetectorFlags detector;
    SettingFlag settings;
  };
  auto texts = std::make_shared<Texts>();
  Usage usage{.name = "options", .summary = "Print the options of detection, interpretation and tracking"};
  usage.flags = {texts->detector.preset_flag(), texts->detector.config_flag(),
                 texts->settings.flag(SettingFlag::Of::kDetector)};
  usage.footer = R"(Prints YAML with units and effects, for --config FILE.
Examples:
  scanbed options --preset robust > mine.yaml
  scanbed detect --laser log:hall.log --track --config mine.yaml --set track.gate_m=0.2)";
  usage.command = [texts] {
    return OptionsCommand{.detector = texts->detector.value(), .settings = texts->settings.values()};
  };
  return usage;
}

}  // namespace scanbed::scenarios
