// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/list_ports.hpp"
#include "hw/serial/serial_port.hpp"
#include "hw/sick/lms_session.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/usage.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {
namespace {

std::string describe(const hw::LmsIdentity& identity) {
  const hw::LmsVariant& variant = identity.status.variant;
  const std::string type = identity.type.empty() ? "an LMS" : one_line(identity.type);
  std::string text = fmt::format("{} at {} baud, {} degrees at {}, {}", type, identity.found_baud,
                                 variant.fov_deg, variant.resolution_cdeg / 100.0,
                                 identity.status.unit == RangeUnit::kMillimetre ? "mm" : "cm");
  for (const auto& error : identity.errors)
    text += fmt::format(", error {} (type {})", error.number, error.type);
  return text;
}

/// What is at a port, in a few words; it is left as it was, but for a stream that it may have sent. Empty
/// where the user broke it off.
std::string probe(const std::string& path) {
  std::string found;
  work_until_interrupted([&](const hw::StopSignal& stop) {
    hw::SerialPort port(path);
    hw::LmsLink link(port, {}, stop);
    try {
      found = describe(hw::find_lms(link, hw::probe_order(9600)));
    } catch (const SensorFault& fault) {
      if (fault.kind() != SensorFault::Kind::kTimeout) throw;
      found = "no LMS answers";
    }
  });
  return found;
}

std::string line_of(const hw::PortName& port, bool is_probing) {
  std::string line = port.path;
  if (port.device != port.path) line += fmt::format(" ({})", port.device);
  if (is_probing) line += ": " + probe(port.path);
  return line + "\n";
}

}  // namespace

ExitCode execute(const DevicesCommand& command) {
  std::vector<hw::PortName> ports;
  for (const std::string& path : command.ports) ports.push_back({path, path});
  if (command.ports.empty()) ports = hw::list_ports();
  if (ports.empty()) log_note("no serial port is here; is the adapter plugged in?");
  ExitCode code = kExitFine;
  for (const hw::PortName& port : ports) {
    // All ports are told about, not the first bad one alone.
    try {
      if (!command.ports.empty()) hw::check_port(port.path);
      const std::string line = line_of(port, command.is_probing);
      if (is_interrupted()) return kExitInterrupted;
      write_whole(std::nullopt, line);
    } catch (const SensorFault& fault) {
      const std::string text = fault.what();
      const std::string start = port.path + ": ";
      log_error(text.starts_with(start) ? text : start + text);
      code = kExitFault;
    }
  }
  return code;
}

Usage devices_usage() {
  auto command = std::make_shared<DevicesCommand>();
  Usage usage{.name = "devices", .summary = "List serial ports, and what is at them"};
  usage.flags = {
      {"PORT", "", "These alone", &command->ports},
      {"--probe", "", "Ask each port for an LMS; sends bytes to whatever is there", &command->is_probing},
  };
  usage.footer =
      R"(Exit code 3 where a PORT is none or cannot be asked; one at which no LMS answers is listed.
Examples:
  scanbed devices
  scanbed devices --probe /dev/ttyUSB0)";
  usage.command = [command] { return *command; };
  return usage;
}

}  // namespace scanbed::scenarios
