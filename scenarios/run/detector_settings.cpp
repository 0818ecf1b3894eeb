// SPDX-License-Identifier: MIT
#include "scenarios/run/detector_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/detect/presets.hpp"
#include "core/detect/table_two.hpp"
#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/table.hpp"
#include "scenarios/load/yaml.hpp"

namespace scanbed::scenarios {
namespace {

DetectorOptions options_of(const std::string& preset) {
  if (const std::optional<DetectorOptions> options = preset_options(preset)) return *options;
  throw InputError(fmt::format("--preset: unknown value {}{}", quote(preset),
                               name_hint(preset, preset_names(), "presets")));
}

// A value out of range is told with its place, like everything else in a file.
void set_at(const Place& place, DetectorOptions& options, const Value& value) {
  const double number = value.number();
  try {
    set_table_two(options, value.name(), number);
  } catch (const InputError& error) {
    refuse(place, error.what());
  }
}

void apply(const TreeNode& root, DetectorOptions& options) {
  const Variables none;
  Table table(Value(root, "detector configuration", none));
  for (const TableTwoEntry& entry : table_two()) {
    if (const auto value = table.take(entry.name)) set_at(value->node().place, options, *value);
  }
  table.finish();
}

}  // namespace

bool is_table_two_name(std::string_view name) {
  return std::any_of(table_two().begin(), table_two().end(),
                     [name](const TableTwoEntry& entry) { return entry.name == name; });
}

DetectorOptions detector_options(const DetectorChoice& choice, std::span<const Setting> settings) {
  DetectorOptions options = options_of(choice.preset);
  if (choice.config) apply(read_yaml(*choice.config), options);
  for (const Setting& setting : settings) {
    TreeNode root;
    set_path(root, setting);
    apply(root, options);
  }
  options.validate();
  return options;
}

}  // namespace scanbed::scenarios
