// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/usage.hpp"

namespace scanbed::scenarios {

// Flags that several subcommands take: each a text with its Flag and the value it stands for.

/// `--set NAME=VALUE`, any number of times.
struct SettingFlag {
  /// What a command can set.
  enum class Of { kBoth, kScenario, kDetector };

  std::vector<std::string> texts;

  Flag flag(Of of = Of::kBoth);
  std::vector<Setting> values() const;
};

/// `--seed N`.
struct SeedFlag {
  std::string text;

  Flag flag();
  std::optional<std::uint64_t> value() const;
};

/// `--seed N` or `--seed A..B`.
struct SeedsFlag {
  std::string text;

  Flag flag();
  std::optional<SeedRange> value() const;
};

/// `--jobs N`.
struct JobsFlag {
  std::string text;

  Flag flag();
  int value() const;  ///< as many as the machine has cores where it is not given
};

/// `--backend NAME`.
struct BackendFlag {
  std::string text = "planar";

  Flag flag();
  sim::Backend value() const;
};

/// `--record FILE`.
struct RecordFlag {
  std::string text;

  Flag flag();
  FlagFile file() const;
};

/// `--preset NAME`, `--config FILE`.
struct DetectorFlags {
  std::string preset;
  std::string config;

  Flag preset_flag();
  Flag config_flag();
  DetectorChoice value() const;
  FlagFile file() const;  ///< of --config
};

/// The argument SCENARIO, once.
Flag one_scenario(std::vector<std::string>& texts);

/// Table II with its defaults, for the help of subcommands that detect.
std::string table_two_text();

}  // namespace scanbed::scenarios
