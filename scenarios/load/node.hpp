// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {

struct NodeEntry;

/// A parsed file as a tree of values, each with its place. What a scalar means is decided by who reads it.
struct TreeNode {
  enum class Kind { kNothing, kScalar, kList, kMap };

  Kind kind = Kind::kNothing;
  Place place;
  std::string text;                ///< scalar
  bool is_quoted = false;          ///< scalar in quotes: text, never a number
  std::vector<TreeNode> items;     ///< list
  std::vector<NodeEntry> entries;  ///< map, in the order of the file; keys are unique
};

/// One "key: value" of a map.
struct NodeEntry {
  std::string key;
  Place place;  ///< of the key
  TreeNode value;
};

/// How many values a tree holds, itself among them.
inline std::size_t count_nodes(const TreeNode& node) {
  std::size_t count = 1;
  for (const TreeNode& item : node.items) count += count_nodes(item);
  for (const NodeEntry& entry : node.entries) count += count_nodes(entry.value);
  return count;
}

/// What stands behind a map's key "id"; valid as long as the map is.
inline std::optional<std::string_view> id_of(const TreeNode& node) {
  for (const NodeEntry& entry : node.entries) {
    if (entry.key == "id") return entry.value.text;
  }
  return std::nullopt;
}

}  // namespace scanbed::scenarios
