// SPDX-License-Identifier: MIT
#include "scenarios/command/open_laser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/sick/sick_lms.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "scenarios/run/detector_settings.hpp"

namespace scanbed::scenarios {
namespace {

constexpr int kMostWarnings = 20;

std::string plural(std::int64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void tell(std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) log_warning(warning);
  warnings.clear();
}

// What is unknown to a scenario may be an option of the detector that is misspelt.
void explain(const InputError& error, std::span<const Setting> settings) {
  const std::string_view message = error.what();
  for (const Setting& setting : settings) {
    const std::string flag = fmt::format("--set {}={}", setting.path, setting.value);
    const std::string hint = near_detector_setting_hint(setting.path);
    if (hint.empty() || !message.starts_with(flag + ": unknown key")) continue;
    throw InputError(fmt::format("{}: neither of a scenario nor an option of the detector{}", flag, hint));
  }
}

}  // namespace

Scenario open_scenario(const std::string& name_or_path, std::span<const Setting> settings,
                       std::optional<std::uint64_t> seed) {
  const auto is_seed = [](const Setting& setting) { return setting.path == "seed"; };
  if (seed && std::any_of(settings.begin(), settings.end(), is_seed)) {
    throw InputError("--seed: is given by --set seed=... too; leave one of them out");
  }
  std::vector<Setting> all(settings.begin(), settings.end());
  // Before it is loaded, since bodies and whole worlds are drawn from it.
  if (seed) all.push_back({.path = "seed", .value = std::to_string(*seed)});
  const std::filesystem::path file = find_scenario(name_or_path);
  try {
    return load_scenario(file, all);
  } catch (const InputError& error) {
    explain(error, settings);
    throw;
  }
}

std::unique_ptr<sim::SimulatedLms> simulate(const Scenario& scenario, sim::Backend backend,
                                            const DetectorOptions& detector) {
  return std::make_unique<sim::SimulatedLms>(scenario.world,
                                             sim::SimulationOptions{.lms = scenario.lms,
                                                                    .duration_s = scenario.duration_s,
                                                                    .seed = scenario.seed,
                                                                    .backend = backend,
                                                                    .detector = detector});
}

std::unique_ptr<hw::ScanReader> open_log(const LaserSpec& spec) {
  // Held back until there is a scan: where there is none, the first says enough.
  struct Warnings {
    int num = 0;
    bool is_open = false;
    std::vector<std::string> held;
  };
  const auto warnings = std::make_shared<Warnings>();
  const auto report = [warnings](const std::string& message) {
    ++warnings->num;
    if (warnings->num > kMostWarnings) return;
    warnings->held.push_back(message);
    if (warnings->num == kMostWarnings) warnings->held.emplace_back("further damaged lines are only counted");
    if (warnings->is_open) tell(warnings->held);
  };
  const hw::ReplayOptions& replay = spec.replay;
  replay.validate();
  hw::RecordingOptions options = spec.log;
  options.is_interrupted = is_interrupted;
  std::unique_ptr<hw::ScanReader> reader;
  try {
    reader = hw::open_recording(spec.target, options, report);
  } catch (const InputError& error) {
    if (warnings->held.empty()) throw;
    throw InputError(fmt::format("{}; the first: {}", error.what(), warnings->held.front()));
  }
  warnings->is_open = true;
  tell(warnings->held);
  if (!replay.speed && replay.from_s == 0.0 && std::isinf(replay.to_s)) return reader;
  return std::make_unique<hw::PacedReplay>(std::move(reader), replay);
}

std::unique_ptr<RangeSensor> open_device(const LaserSpec& spec) {
  if (spec.kind == LaserKind::kScip) return hw::open_scip(spec.scip);
  if (spec.kind == LaserKind::kCola) return hw::open_cola(spec.cola);
  return std::make_unique<hw::SickLms>(spec.sick);
}

void need_simulated(const LaserSpec& spec, std::string_view what) {
  if (spec.kind == LaserKind::kSimulated) return;
  throw InputError(fmt::format("{} only for the simulated laser; found --laser {}", what, spec.text));
}

std::string to_text(const hw::RecordingCounts& counts) {
  return fmt::format("{}, {}, {}", plural(counts.num_scans, "scan"),
                     plural(counts.num_damaged_lines, "damaged line"),
                     plural(counts.num_other_lines, "other line"));
}

AnalysisOptions open_detector(const DetectorChoice& choice, std::span<const Setting> settings,
                              const AnalysisSteps& steps) {
  const DetectorSettings result = detector_settings(choice, settings, steps);
  for (const IdleOption& idle : result.idle) {
    log_warning(fmt::format("{}: changes nothing here, only {} reads it", idle.name, idle.reader));
  }
  return result.options;
}

SortedSettings sort_settings(std::span<const Setting> settings) {
  SortedSettings sorted;
  for (const Setting& setting : settings) {
    (is_detector_setting(setting.path) ? sorted.detector : sorted.scenario).push_back(setting);
  }
  return sorted;
}

void refuse_detector_settings(std::span<const Setting> settings) {
  for (const Setting& setting : settings) {
    if (!is_detector_setting(setting.path)) continue;
    throw InputError("--set " + setting.path +
                     ": is an option of the detector, and none runs here; allowed: the scenario's values");
  }
}

}  // namespace scanbed::scenarios
