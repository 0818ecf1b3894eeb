// SPDX-License-Identifier: MIT
#include "hw/sick/emulator_options.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

constexpr std::array<std::pair<LmsFaultKind, std::string_view>, 11> kNames = {{
    {LmsFaultKind::kGarbage, "garbage"},
    {LmsFaultKind::kHalf, "half"},
    {LmsFaultKind::kFlip, "flip"},
    {LmsFaultKind::kBlindPair, "blind_pair"},
    {LmsFaultKind::kNak, "nak"},
    {LmsFaultKind::kMiss, "miss"},
    {LmsFaultKind::kRefuse, "refuse"},
    {LmsFaultKind::kSilence, "silence"},
    {LmsFaultKind::kReboot, "reboot"},
    {LmsFaultKind::kUnplug, "unplug"},
    {LmsFaultKind::kPollution, "pollution"},
}};

std::string all_names() {
  std::string names;
  for (const auto& [kind, name] : kNames) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace

std::string_view to_string(LmsFaultKind kind) {
  for (const auto& [known, name] : kNames) {
    if (known == kind) return name;
  }
  return "?";
}

LmsFault parse_lms_fault(std::string_view text) {
  const std::size_t at = text.find('@');
  const std::string_view name = text.substr(0, at);
  const std::string whole(text);
  LmsFault fault;
  bool is_known = false;
  for (const auto& [kind, known] : kNames) {
    if (known != name) continue;
    fault.kind = kind;
    is_known = true;
  }
  if (!is_known) throw InputError("fault '" + whole + "': unknown name; there are " + all_names());
  const std::string_view time = at == std::string_view::npos ? "" : text.substr(at + 1);
  const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), fault.at_s);
  const bool is_number = error == std::errc() && end == time.data() + time.size() && !time.empty();
  if (!is_number || !std::isfinite(fault.at_s) || fault.at_s < 0.0) {
    throw InputError("fault '" + whole + "': expected NAME@SECONDS, such as reboot@12.5");
  }
  return fault;
}

void EmulatorOptions::validate() const {
  require(address <= 0x7F, "emulator.address", address, "[0, 127]");
  require(is_lms_baud(power_on_baud), "emulator.power_on_baud", power_on_baud, kLmsBaudNames);
  require(variant.is_offered(), "emulator.variant.resolution", variant.resolution_cdeg / 100.0,
          "0.5 or 1 at 180 degrees, 0.25, 0.5 or 1 at 100");
  require(boot_s >= 0.0 && boot_s <= 60.0, "emulator.boot_s", boot_s, "[0, 60]");
  require(mode_switch_s >= 0.0 && mode_switch_s <= 3.0, "emulator.mode_switch_s", mode_switch_s, "[0, 3]");
  require(write_s >= 0.0 && write_s <= 25.0, "emulator.write_s", write_s, "[0, 25]");
  require(silence_s >= 0.0 && silence_s <= 3600.0, "emulator.silence_s", silence_s, "[0, 3600]");
  require(unplug_s >= 0.0 && unplug_s <= 3600.0, "emulator.unplug_s", unplug_s, "[0, 3600]");
}

}  // namespace scanbed::hw
