// SPDX-License-Identifier: MIT
#include "hw/serial/list_ports.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace scanbed::hw {
namespace {

namespace fs = std::filesystem;

// The kernel names more ports than there are chips; those without one have type 0.
bool has_chip(const fs::path& sys, const std::string& name) {
  std::ifstream file(sys / "class" / "tty" / name / "type");
  int type = 0;
  return file >> type && type != 0;
}

bool is_port(const fs::path& sys, const std::string& name) {
  for (const char* start : {"ttyUSB", "ttyACM", "ttyAMA", "ttyXRUSB"}) {
    if (name.starts_with(start)) return true;
  }
  return name.starts_with("ttyS") && has_chip(sys, name);
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    paths.push_back(entry->path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

std::vector<PortName> list_ports(const fs::path& dev, const fs::path& sys) {
  std::vector<PortName> ports;
  for (const fs::path& link : entries(dev / "serial" / "by-id")) {
    std::error_code error;
    const fs::path device = fs::weakly_canonical(link, error);
    if (!error && fs::exists(device, error)) ports.push_back({link.string(), device.string()});
  }
  for (const fs::path& device : entries(dev)) {
    if (!is_port(sys, device.filename().string())) continue;
    std::error_code error;
    const std::string name = fs::weakly_canonical(device, error).string();
    const bool is_known =
        std::any_of(ports.begin(), ports.end(), [&](const PortName& port) { return port.device == name; });
    if (!is_known) ports.push_back({device.string(), device.string()});
  }
  return ports;
}

}  // namespace scanbed::hw
