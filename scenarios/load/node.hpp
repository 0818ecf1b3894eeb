// SPDX-License-Identifier: MIT
#pragma once

#include <string>
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

}  // namespace scanbed::scenarios
