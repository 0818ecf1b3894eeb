// SPDX-License-Identifier: MIT
#include "scenarios/run/detector_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/detect/presets.hpp"
#include "core/detect/table_two.hpp"
#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "core/options/option_table.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/table.hpp"
#include "scenarios/load/yaml.hpp"

namespace scanbed::scenarios {
namespace {

AnalysisOptions options_of(const std::string& preset) {
  const std::optional<DetectorOptions> detector = preset_options(preset);
  if (!detector) {
    throw InputError(fmt::format("--preset: unknown value {}{}", quote(preset),
                                 name_hint(preset, preset_names(), "presets")));
  }
  AnalysisOptions options;
  options.detector = *detector;
  return options;
}

double number_of(const Option& option, const Value& value) {
  switch (option.kind) {
    case OptionKind::kFlag:
      return value.flag() ? 1.0 : 0.0;
    case OptionKind::kWhole:
      return static_cast<double>(value.count({.least = -1e9, .greatest = 1e9}));
    case OptionKind::kChoice: {
      const std::vector<std::string> words(option.words.begin(), option.words.end());
      return static_cast<double>(value.choice(words));
    }
    case OptionKind::kReal:
      break;
  }
  return value.number();
}

/// Reads one tree of options into `settings`; remembers where each value stood, for errors.
class Reader {
 public:
  explicit Reader(DetectorSettings& settings) : settings_(settings) {}

  void read(const TreeNode& root) {
    const Variables none;
    Table table(Value(root, "detector options", none));
    for (const TableTwoEntry& entry : table_two()) {
      if (const auto value = table.take(entry.name)) set_table_two_at(entry, *value);
    }
    for (const Option& option : option_table()) {
      if (!option.group().empty()) continue;
      if (const auto value = table.take(option.name())) set(option, *value);
    }
    std::string_view last_group;
    for (const Option& option : option_table()) {
      if (option.group().empty() || option.group() == last_group) continue;
      last_group = option.group();
      if (const auto value = table.take(last_group)) read_group(last_group, *value);
    }
    table.finish();
    validate();
  }

 private:
  void read_group(std::string_view group, const Value& value) {
    Table table(value);
    for (const Option& option : option_table()) {
      if (option.group() != group) continue;
      if (const auto entry = table.take(option.name())) set(option, *entry);
    }
    table.finish();
  }

  void set(const Option& option, const Value& value) {
    option.set(settings_.options, number_of(option, value));
    places_[std::string(option.path)] = value.node().place;
    given_.emplace_back(option.path, option.path);
  }

  // A value out of range is told with its place, like everything else in a file.
  void set_table_two_at(const TableTwoEntry& entry, const Value& value) {
    const double number = value.number();
    try {
      set_table_two(settings_.options.detector, entry.name, number);
    } catch (const InputError& error) {
      refuse(value.node().place, error.what());
    }
    places_[std::string(entry.option)] = value.node().place;
    given_.emplace_back(entry.name, entry.option);
  }

  void validate() {
    try {
      settings_.options.validate();
    } catch (const InputError& error) {
      const std::string message = error.what();
      const auto place = places_.find(message.substr(0, message.find(':')));
      if (place == places_.end()) throw;
      refuse(place->second, message);
    }
    const bool is_paper = settings_.options.detector.pipeline == Pipeline::kPaper;
    for (const auto& [name, path] : given_) {
      const Option* option = find_option(path);
      if (option == nullptr || option->reader == OptionReader::kBoth) continue;
      if ((option->reader == OptionReader::kPaper) != is_paper) settings_.idle.push_back(name);
    }
  }

  DetectorSettings& settings_;
  std::map<std::string, Place> places_;
  std::vector<std::pair<std::string, std::string>> given_;  // as it was written, and the option's path
};

std::string comment_of(const Option& option, const AnalysisOptions& options) {
  std::string comment(option.effect);
  if (!option.unit().empty()) comment = fmt::format("[{}] {}", option.unit(), comment);
  if (option.unit() == "rad") comment += fmt::format("; {:.4g} degrees", degrees(option.get(options)));
  if (option.kind == OptionKind::kChoice) comment += fmt::format("; {}", fmt::join(option.words, ", "));
  for (const TableTwoEntry& entry : table_two()) {
    if (entry.option != option.path) continue;
    comment += fmt::format(" (Table II: {}{}{})", entry.name, entry.unit.empty() ? "" : ", ", entry.unit);
  }
  return comment;
}

// What the chosen pipeline does not read is left out of what is printed.
bool is_read(const Option& option, const AnalysisOptions& options) {
  const bool is_paper = options.detector.pipeline == Pipeline::kPaper;
  return option.reader == OptionReader::kBoth || (option.reader == OptionReader::kPaper) == is_paper;
}

}  // namespace

bool is_detector_setting(std::string_view path) {
  const auto rows = table_two();
  if (std::any_of(rows.begin(), rows.end(), [&](const auto& entry) { return entry.name == path; }))
    return true;
  const std::string_view first_step = path.substr(0, path.find('.'));
  const auto options = option_table();
  return std::any_of(options.begin(), options.end(), [&](const Option& option) {
    return option.group() == first_step || option.path == path;
  });
}

DetectorSettings detector_settings(const DetectorChoice& choice, std::span<const Setting> settings) {
  DetectorSettings result{.options = options_of(choice.preset), .idle = {}};
  if (choice.config) Reader(result).read(read_yaml(*choice.config));
  for (const Setting& setting : settings) {
    TreeNode root;
    set_path(root, setting);
    Reader(result).read(root);
  }
  return result;
}

std::string options_yaml(const DetectorChoice& choice, std::span<const Setting> settings) {
  const AnalysisOptions options = detector_settings(choice, settings).options;
  std::string text =
      fmt::format("# Options of preset {}, for --config FILE and --set NAME=VALUE.\n", choice.preset);
  std::string_view group;
  for (const Option& option : option_table()) {
    if (!is_read(option, options)) continue;
    if (option.group() != group) text += fmt::format("{}:\n", option.group());
    group = option.group();
    const std::string entry =
        fmt::format("{}{}: {}", group.empty() ? "" : "  ", option.name(), option.text(options));
    text += fmt::format("{:<36}  # {}\n", entry, comment_of(option, options));
  }
  return text;
}

}  // namespace scanbed::scenarios
