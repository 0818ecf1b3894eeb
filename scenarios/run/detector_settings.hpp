// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/detect/detector_options.hpp"
#include "scenarios/load/set_path.hpp"

namespace scanbed::scenarios {

/// What the command line says about the detector.
struct DetectorChoice {
  std::string preset = "paper";
  std::optional<std::filesystem::path> config;  ///< YAML map of Table II names to numbers
};

/// Whether `name` is one of Table II's parameters.
bool is_table_two_name(std::string_view name);

/// The preset, changed by the file, changed by the settings (Table II names and units).
///
/// @throws InputError for an unknown preset or parameter, and naming parameter, value and allowed range.
DetectorOptions detector_options(const DetectorChoice& choice, std::span<const Setting> settings);

}  // namespace scanbed::scenarios
