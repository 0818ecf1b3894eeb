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
#include "scenarios/command/output.hpp"
#include "scenarios/command/usage.hpp"

namespace scanbed::scenarios {
namespace {

std::string describe(const hw::LmsIdentity& identity) {
  const hw::LmsVariant& variant = identity.status.variant;
  std::string text = fmt::format("{} at {} baud, {} degrees at {}, {}", identity.type, identity.found_baud,
                                 variant.fov_deg, variant.resolution_cdeg / 100.0,
                                 identity.status.unit == RangeUnit::kMillimetre ? "mm" : "cm");
  for (const auto& error : identity.errors)
    text += fmt::format(", error {} (type {})", error.number, error.type);
  return text;
}

/// What is at a port, in a few words; it is left as it was, but for a stream that it may have sent.
std::string probe(const std::string& path) {
  const hw::StopSignal stop;
  try {
    hw::SerialPort port(path);
    hw::LmsLink link(port, {}, stop);
    return describe(hw::find_lms(link, hw::probe_order(9600)));
  } catch (const SensorFault& fault) {
    if (fault.kind() == SensorFault::Kind::kTimeout) return "no LMS answers";
    // The line begins with the port already.
    const std::string text = fault.what();
    return text.starts_with(path + ": ") ? text.substr(path.size() + 2) : text;
  }
}

}  // namespace

ExitCode execute(const DevicesCommand& command) {
  std::vector<hw::PortName> ports;
  for (const std::string& path : command.ports) ports.push_back({path, path});
  if (command.ports.empty()) ports = hw::list_ports();
  if (ports.empty()) log_note("no serial port is here; is the adapter plugged in?");
  for (const hw::PortName& port : ports) {
    if (is_interrupted()) return kExitInterrupted;
    std::string line = port.path;
    if (port.device != port.path) line += fmt::format(" ({})", port.device);
    if (command.is_probing) line += ": " + probe(port.path);
    write_whole(std::nullopt, line + "\n");
  }
  return kExitFine;
}

Usage devices_usage() {
  auto command = std::make_shared<DevicesCommand>();
  Usage usage{.name = "devices", .summary = "List serial ports, and what is at them"};
  usage.flags = {
      {"PORT", "", "These alone", &command->ports},
      {"--probe", "", "Ask each port for an LMS; sends bytes to whatever is there", &command->is_probing},
  };
  usage.footer = R"(Examples:
  scanbed devices
  scanbed devices --probe /dev/ttyUSB0)";
  usage.command = [command] { return *command; };
  return usage;
}

}  // namespace scanbed::scenarios
