// SPDX-License-Identifier: MIT
#include "scenarios/command/shared_flags.hpp"

#include <fmt/format.h>

#include <array>

#include "core/detect/table_two.hpp"
#include "scenarios/command/flag_values.hpp"

namespace scanbed::scenarios {

Flag SettingFlag::flag() {
  return {"--set", "NAME=VALUE",
          "Change one value: of a scenario file by its path, or an option of the detector", &texts};
}

std::vector<Setting> SettingFlag::values() const {
  std::vector<Setting> settings;
  settings.reserve(texts.size());
  for (const std::string& text : texts) settings.push_back(parse_setting(text));
  return settings;
}

Flag SeedFlag::flag() {
  return {"--seed", "N", "In place of the scenario's own", &text};
}

std::optional<std::uint64_t> SeedFlag::value() const {
  if (text.empty()) return std::nullopt;
  return static_cast<std::uint64_t>(to_count("--seed", text, 0));
}

Flag BackendFlag::flag() {
  return {"--backend", "NAME", "Engine of simulated lasers: planar or spatial", &text};
}

sim::Backend BackendFlag::value() const {
  static const std::array<std::string, 2> kBackends = {"planar", "spatial"};
  return sim::parse_backend(kBackends[to_choice("--backend", text, kBackends, "engines")]);
}

Flag RecordFlag::flag() {
  return {"--record", "FILE", "Write scans, features and truth; the ending is the format", &text};
}

Flag DetectorFlags::preset_flag() {
  return {"--preset", "NAME", "Detectors: robust, or the paper's", &preset};
}

Flag DetectorFlags::config_flag() {
  return {"--config", "FILE", "YAML file of options, as 'scanbed options' prints them", &config};
}

DetectorChoice DetectorFlags::value() const {
  return {.preset = preset, .config = to_path(config)};
}

Flag one_scenario(std::vector<std::string>& texts) {
  return {"SCENARIO", "", "Name of the library or YAML file", &texts, true, 1};
}

std::string table_two_text() {
  std::string text = "For --set and --config: what 'scanbed options' prints, or the paper's Table II:\n";
  for (const TableTwoEntry& entry : table_two()) {
    const std::string unit = entry.unit.empty() ? "" : fmt::format(" {}", entry.unit);
    text += fmt::format("  {:<16} {} (default {}{})\n", entry.name, entry.meaning, entry.default_value, unit);
  }
  return text;
}

}  // namespace scanbed::scenarios
