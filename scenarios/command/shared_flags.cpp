// SPDX-License-Identifier: MIT
#include "scenarios/command/shared_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>

#include "core/detect/table_two.hpp"
#include "core/errors/input_error.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {

Flag SettingFlag::flag(Of of) {
  const auto text = [of] {
    switch (of) {
      case Of::kScenario:
        return "Change one value of the scenario file, by its path";
      case Of::kDetector:
        return "Change one option, by its path";
      case Of::kBoth:
        break;
    }
    return "Change one value: of a scenario file by its path, or an option of the detector";
  };
  return {"--set", "NAME=VALUE", text(), &texts};
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

Flag SeedsFlag::flag() {
  return {"--seed", "N|A..B", "In place of the scenario's own; one run for each from A to B", &text};
}

std::optional<SeedRange> SeedsFlag::value() const {
  constexpr std::uint64_t kMostSeeds = 100'000;
  if (text.empty()) return std::nullopt;
  const std::size_t dots = text.find("..");
  const auto seed = [](const std::string& number) {
    return static_cast<std::uint64_t>(to_count("--seed", number, 0));
  };
  if (dots == std::string::npos) return SeedRange{seed(text), seed(text)};
  const SeedRange range{seed(text.substr(0, dots)), seed(text.substr(dots + 2))};
  if (range.last < range.first) throw InputError("--seed: " + quote(text) + ": ends before it begins");
  if (range.last - range.first >= kMostSeeds) {
    throw InputError(fmt::format("--seed: {}: too many; allowed: {} seeds", quote(text), kMostSeeds));
  }
  return range;
}

Flag JobsFlag::flag() {
  return {"--jobs", "N", "Runs at the same time; as many as there are cores", &text};
}

int JobsFlag::value() const {
  constexpr std::int64_t kMostJobs = 256;
  if (text.empty()) return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const std::int64_t count = to_count("--jobs", text, 1);
  require(count <= kMostJobs, "--jobs", static_cast<double>(count), fmt::format("[1, {}]", kMostJobs));
  return static_cast<int>(count);
}

Flag BackendFlag::flag() {
  return {"--backend", "NAME", "Engine of simulated lasers: planar or spatial", &text};
}

sim::Backend BackendFlag::value() const {
  return static_cast<sim::Backend>(to_choice("--backend", text, sim::backend_names(), "engines"));
}

Flag RecordFlag::flag() {
  return {"--record", "FILE",
          "Write scans; the ending is the format, .jsonl and .mcap keep features and truth, too", &text};
}

FlagFile RecordFlag::file() const {
  return {"--record", to_path(text)};
}

Flag DetectorFlags::preset_flag() {
  return {"--preset", "NAME", "Detectors: robust (default), or paper", &preset};
}

Flag DetectorFlags::config_flag() {
  return {"--config", "FILE", "YAML file of options, as 'scanbed options' prints them", &config};
}

DetectorChoice DetectorFlags::value() const {
  return {.preset = preset.empty() ? std::nullopt : std::optional(preset), .config = to_path(config)};
}

FlagFile DetectorFlags::file() const {
  return {"--config", to_path(config)};
}

Flag one_scenario(std::vector<std::string>& texts) {
  return {"SCENARIO", "", "Name of the library or YAML file", &texts, true, 1};
}

std::string table_two_text() {
  std::string text =
      "For --set and --config: what 'scanbed options' prints, or the paper's Table II\n"
      "(with the defaults of preset paper; some are read by that alone):\n";
  for (const TableTwoEntry& entry : table_two()) {
    const std::string unit = entry.unit.empty() ? "" : fmt::format(" {}", entry.unit);
    text += fmt::format("  {:<16} {} (default {}{})\n", entry.name, entry.meaning, entry.default_value, unit);
  }
  return text;
}

}  // namespace scanbed::scenarios
