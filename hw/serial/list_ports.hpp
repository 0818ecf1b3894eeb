// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scanbed::hw {

/// A serial port that the system knows.
struct PortName {
  std::string path;    ///< the name to use: below /dev/serial/by-id where there is one, since that one stays
  std::string device;  ///< "/dev/ttyUSB0"

  friend bool operator==(const PortName&, const PortName&) = default;
};

/// Serial ports, sorted by name, each once: USB adapters, and those of the mainboard that have a chip behind
/// them. Opens none of them.
/// @param dev, sys  where to look; other folders are for tests.
std::vector<PortName> list_ports(const std::filesystem::path& dev = "/dev",
                                 const std::filesystem::path& sys = "/sys");

}  // namespace scanbed::hw
