// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/scan/range_sensor.hpp"
#include "hw/recording/scan_reader.hpp"
#include "scenarios/load/scenario.hpp"
#include "scenarios/load/set_path.hpp"
#include "scenarios/run/detector_settings.hpp"
#include "scenarios/run/laser_spec.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::scenarios {

/// Loads a scenario by name or path; `seed` replaces that of its file.
Scenario open_scenario(const std::string& name_or_path, std::span<const Setting> settings,
                       std::optional<std::uint64_t> seed);

/// The simulated laser of a scenario. @throws InputError where the world cannot be, or not in this engine.
///
/// @param detector  finds the legs that the robot follows, if it follows any.
std::unique_ptr<sim::SimulatedLms> simulate(const Scenario& scenario,
                                            sim::Backend backend = sim::Backend::kPlanar,
                                            const DetectorOptions& detector = {});

/// A recording of any format; its damaged lines become warnings, up to twenty of them.
std::unique_ptr<hw::ScanReader> open_log(const LaserSpec& spec);

/// A laser at a port or in the network. @pre  spec.is_device().
std::unique_ptr<RangeSensor> open_device(const LaserSpec& spec);

/// @throws InputError "--seed: seeds are only for the simulated laser; found --laser log:a.log" unless it is.
void need_simulated(const LaserSpec& spec, std::string_view what);

/// "37 scans, 0 damaged lines, 3 other lines".
std::string to_text(const hw::RecordingCounts& counts);

/// What the command line asks of detection; options that would change nothing become warnings.
AnalysisOptions open_detector(const DetectorChoice& choice, std::span<const Setting> settings,
                              const AnalysisSteps& steps);

/// Settings by what they are for: options of detection and Table II names, all else for the scenario.
struct SortedSettings {
  std::vector<Setting> detector;
  std::vector<Setting> scenario;
};
SortedSettings sort_settings(std::span<const Setting> settings);

/// For commands that run no detector.
/// @throws InputError where a setting is an option of one.
void refuse_detector_settings(std::span<const Setting> settings);

}  // namespace scanbed::scenarios
