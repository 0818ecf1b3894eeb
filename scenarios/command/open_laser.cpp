// SPDX-License-Identifier: MIT
#include "scenarios/command/open_laser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/sick/sick_lms.hpp"
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
  return load_scenario(find_scenario(name_or_path), all);
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
  const auto report = [num_warnings = 0](const std::string& message) mutable {
    ++num_warnings;
    if (num_warnings <= kMostWarnings) log_warning(message);
    if (num_warnings == kMostWarnings) log_warning("further damaged lines are only counted");
  };
  const hw::ReplayOptions& replay = spec.replay;
  replay.validate();
  hw::RecordingOptions options = spec.log;
  options.is_interrupted = is_interrupted;
  auto reader = hw::open_recording(spec.target, options, report);
  if (!replay.speed && replay.from_s == 0.0 && std::isinf(replay.to_s)) return reader;
  return std::make_unique<hw::PacedReplay>(std::move(reader), replay);
}

std::unique_ptr<RangeSensor> open_device(const LaserSpec& spec) {
  if (spec.kind == LaserKind::kScip) return hw::open_scip(spec.scip);
  if (spec.kind == LaserKind::kCola) return hw::open_cola(spec.cola);
  return std::make_unique<hw::SickLms>(spec.sick);
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

}  // namespace scanbed::scenarios
