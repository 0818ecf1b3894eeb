// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <thread>

#include "hw/sick/emulator_server.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/output.hpp"
#include "scenarios/run/emulation.hpp"
#include "scenarios/run/truth_file.hpp"

namespace scanbed::scenarios {
namespace {

using Clock = std::chrono::steady_clock;

/// Serves in a thread of its own until the user or the time ends it, or the source of the scans fails.
void serve(hw::EmulatorServer& server, const std::optional<double>& duration_s) {
  hw::StopSignal stop;
  std::exception_ptr failure;
  std::atomic<bool> has_ended = false;
  std::thread thread([&] {
    try {
      server.run(stop);
    } catch (...) {
      failure = std::current_exception();
    }
    has_ended = true;
  });
  const auto start = Clock::now();
  const auto is_over = [&] {
    return duration_s && Clock::now() - start >= std::chrono::duration<double>(*duration_s);
  };
  while (!is_interrupted() && !has_ended && !is_over())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  stop.give();
  thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

ExitCode execute(const EmulateCommand& command) {
  const Scenario scenario = open_scenario(command.scenario, command.settings, command.seed);
  hw::EmulatorOptions options = emulator_options(scenario);
  options.address = command.address;
  options.power_on_baud = command.baud;
  options.is_paced = !command.is_unpaced;
  options.faults = command.faults;
  std::optional<TruthWriter> truth;
  if (command.truth) truth.emplace(*command.truth);
  std::vector<double> range_m;
  hw::EmulatorServer server(
      options, scenario_scans(scenario),
      [&](const hw::SentScan& sent) {
        if (!truth || sent.truth == nullptr) return;
        range_m.resize(sent.words.size());
        decode_lms_words(sent.words, sent.unit, sent.format, range_m);
        truth->write(sent.number, range_m, *sent.truth);
      },
      command.link);
  write_whole(std::nullopt, server.port() + "\n");
  log_note(fmt::format("a simulated LMS 200 is at {}; end it with Ctrl-C", server.port()));
  serve(server, command.duration_s);
  return is_interrupted() ? kExitInterrupted : kExitFine;
}

}  // namespace scanbed::scenarios
