// SPDX-License-Identifier: MIT
#include "scenarios/load/load_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/errors/input_error.hpp"
#include "scenarios/load/include.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"
#include "scenarios/load/yaml.hpp"
#include "sim/sensor/sensor_presets.hpp"

namespace scanbed::scenarios {
namespace {

constexpr double kLongest_s = 86'400.0;

bool is_name(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

// A scenario's name becomes part of file names.
std::string load_name(const Value& value) {
  std::string name = value.text();
  if (!is_name(name)) value.refuse("expected letters, digits, _ and - only, found " + quote(name));
  return name;
}

Variables load_variables(const Value& value) {
  Variables variables;
  // Not Table::take_all's own: those above a variable in the file are in force for it already.
  for (const Value& written : Table(value).take_all()) {
    if (!is_name(written.name())) written.refuse("a variable's name has letters, digits, _ and - only");
    variables[written.name()] = Value(written.node(), written.name(), variables, written.notes()).number();
  }
  return variables;
}

/// How long a scenario is, and whether its file says so or who runs it.
struct Duration {
  double s = 0.0;
  bool is_of_file = true;
};

// Pictures that a shorter duration of the command line leaves no time for are left out.
std::vector<double> load_times(Table& table, std::string_view key, const Duration& duration) {
  std::vector<double> times_s;
  const std::optional<Value> value = table.take(key);
  if (!value) return times_s;
  for (const Value& item : value->items()) {
    const double greatest_s = duration.is_of_file ? duration.s : kLongest_s;
    times_s.push_back(item.number({.least = 0.0, .greatest = greatest_s}));
    if (times_s.back() > duration.s) times_s.pop_back();
  }
  std::sort(times_s.begin(), times_s.end());
  return times_s;
}

void load_outputs(const Value& value, const Duration& duration, Scenario& scenario) {
  Table outputs(value);
  if (const auto section = outputs.take("pictures")) {
    Table pictures(*section);
    scenario.pictures.top_s = load_times(pictures, "top", duration);
    scenario.pictures.camera_s = load_times(pictures, "camera", duration);
    scenario.pictures.laser_s = load_times(pictures, "laser", duration);
    pictures.finish();
  }
  outputs.finish();
}

Duration load_header(Table& table, Scenario& scenario) {
  const Value schema = table.need("schema");
  if (schema.count() != 1) schema.refuse("this version reads schema 1");
  scenario.name = load_name(table.need("name"));
  scenario.description = table.text("description", "");
  if (const auto seed = table.take("seed")) {
    scenario.seed = static_cast<std::uint64_t>(seed->count({.least = 0.0}));
  }
  const Value duration = table.need("duration");
  scenario.duration_s = duration.number({.least = 0.0, .greatest = kLongest_s, .open = true});
  scenario.known_fail = take_known_fail(table);
  return {scenario.duration_s, duration.node().place.line > 0};
}

Scenario load_tree(const Value& root) {
  Scenario scenario;
  scenario.lms = sim::sensor_preset("sick_lms200");
  Table table(root);
  table.take("vars");                                                       // read before
  if (const auto include = table.take("include")) include_names(*include);  // resolved before
  const Duration duration = load_header(table, scenario);
  if (const auto sensor = table.take("sensor")) load_sensor(*sensor, scenario);
  if (const auto generate = table.take("generate")) load_generated(*generate, scenario);
  if (const auto robot = table.take("robot")) load_robot(*robot, scenario.world.robot);
  if (const auto world = table.take("world")) load_solids(*world, scenario.world.solids);
  if (const auto actors = table.take("actors")) load_actors(*actors, scenario);
  if (const auto score = table.take("score")) load_score(*score, scenario);
  if (const auto expect = table.take("expect")) load_expect(*expect, scenario);
  if (const auto outputs = table.take("outputs")) load_outputs(*outputs, duration, scenario);
  table.finish();
  return scenario;
}

Scenario read_tree(const TreeNode& root, const Notes& notes) {
  const Variables none;
  const Value whole(root, "scenario", none, notes);
  // vars are known before anything that may refer to them, wherever they stand in the file.
  Table peek(whole);
  const std::optional<Value> section = peek.take("vars");
  const Variables variables = section ? load_variables(*section) : Variables{};
  return load_tree(Value(root, "scenario", variables, notes));
}

/// An object of the file and where a message first quotes its id.
struct Named {
  const TreeNode* node = nullptr;
  std::size_t at = std::string_view::npos;
};

// Of "solid 'col_L': ..."; of a bench's foot "'bench_L.foot_0'".
std::size_t find_quoted(std::string_view message, const std::string& id) {
  const std::string name = "'" + id;
  return std::min(message.find(name + "'"), message.find(name + "."));
}

// The object that a message names first: that is whose fault it is.
Named find_named_in(std::string_view message, const TreeNode& node) {
  Named first;
  const auto take = [&](const Named& other) {
    if (other.at < first.at) first = other;
  };
  for (const NodeEntry& entry : node.entries) {
    if (entry.key == "id") take({&node, find_quoted(message, entry.value.text)});
    take(find_named_in(message, entry.value));
  }
  for (const TreeNode& item : node.items) take(find_named_in(message, item));
  return first;
}

// Where to look for what a message is about: the object that it names, else the section that it begins with.
Place place_of(std::string_view message, const TreeNode& root) {
  if (const TreeNode* named = find_named_in(message, root).node) return named->place;
  for (const NodeEntry& entry : root.entries) {
    if (message.starts_with(entry.key)) return entry.value.place;
  }
  return {root.place.source, 0, 0};
}

// Everything above checks single values; here the parts check each other.
void validate_parts(const Scenario& scenario, const TreeNode& root) {
  try {
    scenario.lms.validate();
    scenario.match.validate();
    scenario.world.validate();
  } catch (const InputError& error) {
    refuse(place_of(error.what(), root), error.what());
  }
}

// Those of the file have been followed by now.
void refuse_include_of_setting(const TreeNode& root) {
  for (const NodeEntry& entry : root.entries) {
    if (entry.key == "include") refuse(entry.place, "include: only a file includes others");
  }
}

// Where a document comes from.
struct Origin {
  std::string name;
  std::filesystem::path folder;  // empty where it is no file
};

// A variable that nothing reads would change nothing.
void check_variable(const TreeNode& root, const Setting& setting) {
  constexpr std::string_view kSection = "vars.";
  if (!setting.path.starts_with(kSection)) return;
  const std::string name = setting.path.substr(kSection.size());
  std::vector<std::string> known;
  for (const NodeEntry& section : root.entries) {
    if (section.key != "vars") continue;
    for (const NodeEntry& variable : section.value.entries) known.push_back(variable.key);
  }
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  throw InputError(fmt::format("--set {}: there is no variable {}{}", setting.path, quote(name),
                               name_hint(name, known, "variables")));
}

Scenario load_document(TreeNode root, const Origin& origin, std::span<const Setting> settings) {
  resolve_includes(root, origin.folder);
  for (const Setting& setting : settings) {
    check_variable(root, setting);
    set_path(root, setting);
  }
  refuse_include_of_setting(root);
  if (root.kind == TreeNode::Kind::kNothing) {
    throw InputError(origin.name + ": is empty; expected a scenario");
  }
  Scenario scenario = read_tree(root, {});
  validate_parts(scenario, root);
  return scenario;
}

}  // namespace

void read_scenario(const TreeNode& root, AskedRecorder& recorder) {
  read_tree(root, {&recorder, &recorder.root});
}

Scenario load_scenario(const std::filesystem::path& path, std::span<const Setting> settings) {
  // "./" where the path is a bare name: a folder that is empty is none.
  return load_document(read_yaml(path), {path.string(), "." / path.parent_path()}, settings);
}

Scenario parse_scenario(std::string_view text, const std::string& source, std::span<const Setting> settings) {
  return load_document(parse_yaml(text, source), {source, {}}, settings);
}

}  // namespace scanbed::scenarios
