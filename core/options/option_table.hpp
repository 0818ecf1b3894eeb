// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/options/analysis_options.hpp"

namespace scanbed {

enum class OptionKind { kReal, kWhole, kFlag, kChoice };

/// What reads an option.
enum class OptionReader {
  kBoth,            ///< both pipelines
  kPaper,           ///< the paper pipeline
  kRobust,          ///< the robust pipeline
  kLegRules,        ///< rules that tell legs: leg.scorer
  kSegments,        ///< the paper pipeline, and rules that tell legs in any
  kInterpretation,  ///< of scenes, after any detection
  kTracking,        ///< after any detection
};

/// "the paper pipeline"; for a message that only this reads the option.
std::string_view to_string(OptionReader reader);

/// One option by its public name: what configuration files say, and what it does.
struct Option {
  std::string_view path;    ///< "circle.max_std_rad": the group and the name of the field
  std::string_view effect;  ///< one line
  OptionKind kind = OptionKind::kReal;
  OptionReader reader = OptionReader::kBoth;
  std::span<const std::string_view> words;  ///< of a choice, in the order of its values
  double (*get)(const AnalysisOptions&) = nullptr;
  void (*set)(AnalysisOptions&, double) = nullptr;  ///< unchecked: AnalysisOptions::validate() checks

  std::string_view group() const;  ///< "circle"; empty where the option stands in none
  std::string_view name() const;   ///< "max_std_rad"
  std::string_view unit() const;   ///< "rad", as the name's ending says; empty where it has none
  /// Whether it makes a difference beside the other options, where scenes are interpreted and tracked.
  bool is_read(const AnalysisOptions& options) const;
  /// The value as configuration files write it.
  std::string text(const AnalysisOptions& options) const;
};

/// All options, group by group.
std::span<const Option> option_table();

/// @returns nullptr where there is no such option.
const Option* find_option(std::string_view path);

}  // namespace scanbed
