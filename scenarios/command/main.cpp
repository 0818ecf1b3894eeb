// SPDX-License-Identifier: MIT
#include <exception>
#include <variant>

#include "core/errors/input_error.hpp"
#include "hw/serial/stop_signal.hpp"
#include "scenarios/command/command_line.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/standard_streams.hpp"

int main(int argc, char** argv) {
  using namespace scanbed;
  using namespace scanbed::scenarios;
  keep_standard_streams();
  try {
    watch_signals();
    const ExitCode code =
        std::visit([](const auto& command) { return execute(command); }, parse_command_line(argc, argv));
    // As shells count: 130 for SIGINT, 143 for SIGTERM, 129 for SIGHUP.
    return code == kExitInterrupted ? 128 + interrupting_signal() : code;
  } catch (const hw::Stopped&) {  // interrupted before there was anything to finish
    return 128 + interrupting_signal();
  } catch (const InputError& error) {
    log_error(error.what());
    return kExitBadInput;
  } catch (const std::exception& error) {  // SensorFault, OutputFault, and what the system refuses
    log_error(error.what());
    return kExitFault;
  }
}
