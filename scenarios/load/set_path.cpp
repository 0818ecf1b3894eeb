// SPDX-License-Identifier: MIT
#include "scenarios/load/set_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/node.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/yaml.hpp"

namespace scanbed::scenarios {
namespace {

constexpr std::ptrdiff_t kMostSteps = 16;

// All places within become the flag itself: its value has no line.
void set_source(TreeNode& node, const Place& flag) {
  node.place = flag;
  for (TreeNode& item : node.items) set_source(item, flag);
  for (NodeEntry& entry : node.entries) {
    entry.place = flag;
    set_source(entry.value, flag);
  }
}

TreeNode& step_into_map(TreeNode& map, const std::string& key, const Place& flag) {
  if (map.kind == TreeNode::Kind::kNothing) {
    map.kind = TreeNode::Kind::kMap;
    map.place = flag;
  }
  for (NodeEntry& entry : map.entries) {
    if (entry.key == key) return entry.value;
  }
  map.entries.push_back({key, flag, {}});
  map.entries.back().value.place = flag;
  return map.entries.back().value;
}

TreeNode& step_into_list(TreeNode& list, const std::string& step, const Place& flag) {
  std::vector<std::string> ids;
  for (TreeNode& item : list.items) {
    const std::optional<std::string_view> id = id_of(item);
    if (id == step) return item;
    if (id) ids.emplace_back(*id);
  }
  const std::optional<std::int64_t> index = parse_count(step);
  if (index && static_cast<std::size_t>(*index) < list.items.size()) {
    return list.items[static_cast<std::size_t>(*index)];
  }
  refuse(flag, fmt::format("no element {} among {}{}", quote(step), list.items.size(),
                           name_hint(step, ids, "ids")));
}

TreeNode& step_into(TreeNode& node, const std::string& step, const Place& flag) {
  if (node.kind == TreeNode::Kind::kList) return step_into_list(node, step, flag);
  if (node.kind == TreeNode::Kind::kScalar) {
    refuse(flag, fmt::format("cannot go into a single value at {}", quote(step)));
  }
  return step_into_map(node, step, flag);
}

}  // namespace

Setting parse_setting(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    throw InputError(fmt::format("--set: expected PATH=VALUE, found {}", quote(text)));
  }
  return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

void set_path(TreeNode& root, const Setting& setting) {
  const auto source = std::make_shared<const Source>(Source{"--set " + setting.path + "=" + setting.value});
  const Place flag{source, 0, 0};
  if (std::count(setting.path.begin(), setting.path.end(), '.') > kMostSteps) {
    refuse(flag, fmt::format("path is too long; allowed: {} steps", kMostSteps));
  }
  TreeNode* node = &root;
  for (std::size_t begin = 0; begin <= setting.path.size();) {
    const std::size_t end = std::min(setting.path.find('.', begin), setting.path.size());
    node = &step_into(*node, setting.path.substr(begin, end - begin), flag);
    begin = end + 1;
  }
  *node = parse_yaml(setting.value, source->name);
  set_source(*node, flag);
}

}  // namespace scanbed::scenarios
