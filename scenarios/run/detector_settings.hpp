// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/options/analysis_options.hpp"
#include "scenarios/load/set_path.hpp"

namespace scanbed::scenarios {

/// What the command line says about the detector.
struct DetectorChoice {
  std::optional<std::string> preset;  ///< else that of the pipeline that is asked for, else kDefaultPreset
  std::optional<std::filesystem::path>
      config;  ///< YAML of options, as `scanbed options` prints, or Table II names
};

inline constexpr const char* kDefaultPreset = "robust";

/// What is done with the features of a scan; interpretation asks what moves, and so tracks.
struct AnalysisSteps {
  bool tracks = true;
  bool interprets = true;
};

/// An option that was asked for, but changes nothing.
struct IdleOption {
  std::string name;         ///< as it was given
  std::string_view reader;  ///< what alone reads it

  friend bool operator==(const IdleOption&, const IdleOption&) = default;
};

/// Options, and which of those asked for change nothing.
struct DetectorSettings {
  AnalysisOptions options;
  std::vector<IdleOption> idle;
};

/// Whether `path` is one of Table II's parameters, or lies in a group of options: then it is not the
/// scenario's.
bool is_detector_setting(std::string_view path);

/// "; did you mean 'surface.arc_price'?" for a path that is no detector's setting; empty where none is near.
std::string near_detector_setting_hint(std::string_view path);

/// The preset, changed by the file, changed by the settings: options by their path ("circle.max_std_rad"), or
/// Table II's names in its units. A pipeline that file or settings choose brings its preset's values with it.
///
/// @param steps  what of a file's options they leave unread is not counted as idle: it may serve other runs.
/// @throws InputError for an unknown preset, group or option, and naming option, value and allowed range; for
///                    a file that is empty, gives one option under both its names; for a pipeline of another
///                    preset than the one asked for.
DetectorSettings detector_settings(const DetectorChoice& choice, std::span<const Setting> settings,
                                   const AnalysisSteps& steps = {});

/// The preset whose pipeline these options choose, whatever was changed in it.
std::string preset_of(const AnalysisOptions& options);

/// All options of a preset as YAML for `--config`, with units, effects and Table II's names beside them.
///
/// @throws InputError for an unknown preset.
std::string options_yaml(const DetectorChoice& choice, std::span<const Setting> settings);

}  // namespace scanbed::scenarios
