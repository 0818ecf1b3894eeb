// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "core/errors/input_error.hpp"
#include "hw/sick/emulator_server.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/run/emulation.hpp"
#include "scenarios/run/output.hpp"
#include "scenarios/run/truth_file.hpp"

namespace scanbed::scenarios {
namespace {

struct EmulateTexts {
  std::vector<std::string> scenarios;
  std::string link;
  std::string truth;
  bool is_unpaced = false;
  std::vector<std::string> faults;
  std::string address = "0";
  std::string baud = "9600";
  std::string duration;
  SeedFlag seed;
  BackendFlag backend;
  SettingFlag settings;
};

EmulateCommand to_emulate(const EmulateTexts& texts) {
  check_files(std::array{FlagFile{"--truth", to_path(texts.truth)}}, scenario_files(texts.scenarios));
  EmulateCommand command{.scenario = texts.scenarios.front(),
                         .link = texts.link,
                         .truth = to_file("--truth", texts.truth),
                         .is_unpaced = texts.is_unpaced,
                         .seed = texts.seed.value(),
                         .backend = texts.backend.value(),
                         .settings = texts.settings.values()};
  for (const std::string& fault : texts.faults) command.faults.push_back(hw::parse_lms_fault(fault));
  command.address = static_cast<std::uint8_t>(to_count("--address", texts.address, 0, 127));
  const std::int64_t baud = to_count("--baud", texts.baud, 1);
  require(hw::is_lms_baud(baud), "--baud", static_cast<double>(baud), hw::kLmsBaudNames);
  command.baud = static_cast<int>(baud);
  if (!texts.duration.empty()) {
    command.duration_s = to_time_s("--for", texts.duration);
    require(*command.duration_s >= 0.0, "--for", *command.duration_s, ">= 0");
  }
  return command;
}

}  // namespace

ExitCode execute(const EmulateCommand& command) {
  refuse_detector_settings(command.settings);
  const Scenario scenario = open_scenario(command.scenario, command.settings, command.seed);
  hw::EmulatorOptions options = emulator_options(scenario);
  if (const auto difference = unlike_an_lms(scenario)) log_warning(*difference);
  options.address = command.address;
  options.power_on_baud = command.baud;
  options.is_paced = !command.is_unpaced;
  options.faults = command.faults;
  simulate(scenario, command.backend, {});  // what it cannot be shows now, not to the first host
  std::optional<TruthWriter> truth;
  if (command.truth) truth.emplace(*command.truth);
  std::vector<double> range_m;
  hw::EmulatorServer server(
      options, scenario_scans(scenario, command.backend),
      [&](const hw::SentScan& sent) {
        if (!truth || sent.truth == nullptr) return;
        range_m.resize(sent.words.size());
        decode_lms_words(sent.words, sent.unit, sent.format, range_m);
        truth->write(sent.number, range_m, *sent.truth);
      },
      command.link);
  if (truth) truth->begin();  // only now: another emulator at this name may be writing there
  write_whole(std::nullopt, server.port() + "\n");
  log_note(fmt::format("a simulated LMS 200 is at {}; end it with Ctrl-C", server.port()));
  work_until_interrupted([&](const hw::StopSignal& stop) { server.run(stop); }, command.duration_s);
  return is_interrupted() ? kExitInterrupted : kExitFine;
}

Usage emulate_usage() {
  auto texts = std::make_shared<EmulateTexts>();
  Usage usage{.name = "emulate", .summary = "Be an LMS 200 in a scenario's world, at a serial port"};
  usage.flags = {
      one_scenario(texts->scenarios),
      {"--link", "PATH", "Name for the port", &texts->link},
      {"--truth", "FILE", "Write truth of each scan that is sent", &texts->truth},
      {"--unpaced", "", "As fast as the host reads, not as fast as the link", &texts->is_unpaced},
      {"--fault", "NAME@SECONDS", "Something goes wrong at a time; may be repeated", &texts->faults},
      {"--address", "N", "Of the sensor, 0 to 127; real ones have 0 or 1", &texts->address},
      {"--baud", "BAUD", "After power-on", &texts->baud},
      {"--for", "SECONDS", "End after so many seconds", &texts->duration},
      texts->seed.flag(),
      texts->backend.flag(),
      texts->settings.flag(SettingFlag::Of::kScenario),
  };
  usage.footer =
      R"(Prints the port, then serves it. With each scan the world goes on by the scenario's own scan period,
whatever the link takes for it, and begins anew where the scenario ends. Where speeds matter, let both be the same:
at 500000 baud the sensor sends every scan.
Faults: garbage, half, flip, blind_pair, nak, miss, refuse, silence, reboot, unplug, pollution.
Examples:
  scanbed emulate static_hallway --link /tmp/lms --truth truth.jsonl --set sensor.link=rs422_500k
  scanbed run static_hallway --laser 'sick:/tmp/lms?baud=500000' --truth truth.jsonl --set sensor.link=rs422_500k
  scanbed emulate static_hallway --link /tmp/lms --fault flip@3 --fault reboot@10)";
  usage.command = [texts] { return to_emulate(*texts); };
  return usage;
}

}  // namespace scanbed::scenarios
