// SPDX-License-Identifier: MIT
#include "scenarios/load/merge_trees.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "scenarios/load/node.hpp"

namespace scanbed::scenarios {
namespace {

bool has_ids(const TreeNode& list) {
  return list.kind == TreeNode::Kind::kList && !list.items.empty() &&
         std::all_of(list.items.begin(), list.items.end(),
                     [](const TreeNode& item) { return id_of(item).has_value(); });
}

void lay_over_map(TreeNode& base, TreeNode over) {
  for (NodeEntry& entry : over.entries) {
    const auto same = std::find_if(base.entries.begin(), base.entries.end(),
                                   [&](const NodeEntry& candidate) { return candidate.key == entry.key; });
    if (same == base.entries.end()) {
      base.entries.push_back(std::move(entry));
    } else if (entry.value.kind == TreeNode::Kind::kNothing) {
      base.entries.erase(same);
    } else {
      same->place = entry.place;
      lay_over(same->value, std::move(entry.value));
    }
  }
  base.place = over.place;
}

void lay_over_list(TreeNode& base, TreeNode over) {
  const std::size_t num_of_base = base.items.size();
  for (TreeNode& item : over.items) {
    const auto behind = base.items.begin() + static_cast<std::ptrdiff_t>(num_of_base);
    const auto same = std::find_if(base.items.begin(), behind, [&](const TreeNode& candidate) {
      return id_of(candidate) == id_of(item);
    });
    if (same == behind) {
      base.items.push_back(std::move(item));
    } else {
      lay_over(*same, std::move(item));
    }
  }
  base.place = over.place;
}

}  // namespace

void lay_over(TreeNode& base, TreeNode over) {
  if (base.kind == TreeNode::Kind::kMap && over.kind == TreeNode::Kind::kMap) {
    lay_over_map(base, std::move(over));
  } else if (has_ids(base) && has_ids(over)) {
    lay_over_list(base, std::move(over));
  } else {
    base = std::move(over);
  }
}

}  // namespace scanbed::scenarios
