// SPDX-License-Identifier: MIT
#include "scenarios/run/detector_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

/// An option as it was asked for.
struct Given {
  std::string name;       // of Table II, or the path
  std::string_view path;  // of the option; empty where Table II has it for completeness alone
  Place place;
};

/// Reads one tree of options into `options`; remembers where each value stood, for errors.
class Reader {
 public:
  explicit Reader(AnalysisOptions& options) : options_(options) {}

  const std::vector<Given>& given() const { return given_; }

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
    option.set(options_, number_of(option, value));
    note(std::string(option.path), option.path, value);
  }

  // A value out of range is told with its place, like everything else in a file.
  void set_table_two_at(const TableTwoEntry& entry, const Value& value) {
    const double number = value.number();
    try {
      set_table_two(options_.detector, entry.name, number);
    } catch (const InputError& error) {
      refuse(value.node().place, error.what());
    }
    note(std::string(entry.name), entry.option, value);
  }

  // One option may have two names; which of two values was meant, nobody could tell.
  void note(std::string name, std::string_view path, const Value& value) {
    const Place& place = value.node().place;
    if (const Given* other = find(path)) {
      refuse(place, fmt::format("{}: is {} by another name, which is given on line {}", name, other->name,
                                other->place.line));
    }
    given_.push_back({std::move(name), path, place});
  }

  const Given* find(std::string_view path) const {
    const auto found =
        std::find_if(given_.begin(), given_.end(), [&](const Given& given) { return given.path == path; });
    return found == given_.end() ? nullptr : &*found;
  }

  AnalysisOptions& options_;
  std::vector<Given> given_;
};

// When all are read, since what must fit together must not hang on their order.
void validate(const AnalysisOptions& options, const std::vector<Given>& given) {
  try {
    options.validate();
  } catch (const InputError& error) {
    const std::string message = error.what();
    const std::string path = message.substr(0, message.find(':'));
    const auto last =
        std::find_if(given.rbegin(), given.rend(), [&](const Given& one) { return one.path == path; });
    if (last == given.rend()) throw;
    refuse(last->place, message);
  }
}

/// The options' values before any is given: those of the preset that is named, be it by the pipeline alone.
std::string preset_to_begin_with(const DetectorChoice& choice, const std::vector<TreeNode>& trees) {
  if (choice.preset) return *choice.preset;
  std::string preset = kDefaultPreset;
  const auto names = preset_names();
  for (const TreeNode& tree : trees) {
    for (const NodeEntry& entry : tree.entries) {
      const bool is_preset = std::find(names.begin(), names.end(), entry.value.text) != names.end();
      if (entry.key == "pipeline" && is_preset) preset = entry.value.text;
    }
  }
  return preset;
}

TreeNode read_config(const std::filesystem::path& path) {
  TreeNode root = read_yaml(path);
  if (root.kind == TreeNode::Kind::kNothing) {
    throw InputError(path.string() + ": is empty; expected options, see 'scanbed options'");
  }
  return root;
}

bool is_among(const AnalysisSteps& steps, OptionReader reader) {
  if (reader == OptionReader::kInterpretation) return steps.interprets;
  if (reader == OptionReader::kTracking) return steps.tracks || steps.interprets;
  return true;
}

void list_idle(const std::vector<Given>& given, const AnalysisOptions& options, const AnalysisSteps& steps,
               std::vector<IdleOption>& idle) {
  for (const Given& one : given) {
    const Option* option = find_option(one.path);
    if (option == nullptr || (option->is_read(options) && is_among(steps, option->reader))) continue;
    idle.push_back({one.name, to_string(option->reader)});
  }
}

// Which of the two was meant, nobody could tell.
void refuse_another_preset(const DetectorChoice& choice, const std::vector<Given>& given,
                           const AnalysisOptions& options) {
  const auto pipeline =
      std::find_if(given.rbegin(), given.rend(), [](const Given& one) { return one.path == "pipeline"; });
  if (!choice.preset || pipeline == given.rend() || preset_of(options) == *choice.preset) return;
  refuse(pipeline->place, fmt::format("pipeline: is {}, but --preset is {}; allowed: one of the two",
                                      preset_of(options), *choice.preset));
}

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

std::string near_detector_setting_hint(std::string_view path) {
  std::vector<std::string> names;
  for (const TableTwoEntry& entry : table_two()) names.emplace_back(entry.name);
  for (const Option& option : option_table()) names.emplace_back(option.path);
  return near_name_hint(path, names);
}

DetectorSettings detector_settings(const DetectorChoice& choice, std::span<const Setting> settings,
                                   const AnalysisSteps& steps) {
  std::vector<TreeNode> trees;
  if (choice.config) trees.push_back(read_config(*choice.config));
  for (const Setting& setting : settings) set_path(trees.emplace_back(), setting);
  AnalysisOptions options = options_of(preset_to_begin_with(choice, trees));
  std::vector<Given> in_file;
  std::vector<Given> set;
  const std::size_t num_files = choice.config ? 1 : 0;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    Reader reader(options);
    reader.read(trees[i]);
    std::vector<Given>& given = i < num_files ? in_file : set;
    given.insert(given.end(), reader.given().begin(), reader.given().end());
  }
  std::vector<Given> all = in_file;
  all.insert(all.end(), set.begin(), set.end());
  refuse_another_preset(choice, all, options);
  validate(options, all);
  // In the end, since a later setting may choose who reads an earlier one.
  std::vector<IdleOption> idle;
  list_idle(in_file, options, {}, idle);
  list_idle(set, options, steps, idle);
  return {.options = options, .idle = idle};
}

std::string preset_of(const AnalysisOptions& options) {
  return std::string(kPipelineWords.at(static_cast<std::size_t>(options.detector.pipeline)));
}

std::string options_yaml(const DetectorChoice& choice, std::span<const Setting> settings) {
  const AnalysisOptions options = detector_settings(choice, settings).options;
  std::string text =
      fmt::format("# Options of preset {}, for --config FILE and --set NAME=VALUE.\n", preset_of(options));
  std::string_view group;
  for (const Option& option : option_table()) {
    if (!option.is_read(options)) continue;  // would only change nothing
    if (option.group() != group) text += fmt::format("{}:\n", option.group());
    group = option.group();
    const std::string entry =
        fmt::format("{}{}: {}", group.empty() ? "" : "  ", option.name(), option.text(options));
    text += fmt::format("{:<36}  # {}\n", entry, comment_of(option, options));
  }
  return text;
}

}  // namespace scanbed::scenarios
