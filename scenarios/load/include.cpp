// SPDX-License-Identifier: MIT
#include "scenarios/load/include.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "scenarios/load/confined_path.hpp"
#include "scenarios/load/merge_trees.hpp"
#include "scenarios/load/node.hpp"
#include "scenarios/load/value.hpp"
#include "scenarios/load/yaml.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;

class Includer {
 public:
  explicit Includer(const IncludeLimits& limits) : limits_(limits) {}

  void resolve(TreeNode& root, const fs::path& folder) {
    const auto is_include = [](const NodeEntry& entry) { return entry.key == "include"; };
    const auto found = std::find_if(root.entries.begin(), root.entries.end(), is_include);
    if (found == root.entries.end()) return;
    const TreeNode names = std::move(found->value);
    root.entries.erase(found);
    TreeNode base;
    const Variables none;
    for (const auto& [place, name] : include_names(Value(names, "include", none))) {
      add(place, name, folder, base);
    }
    lay_over(base, std::move(root));
    root = std::move(base);
  }

 private:
  void add(const Place& place, const std::string& name, const fs::path& folder, TreeNode& base) {
    if (++num_files_ > limits_.max_files) {
      refuse(place, fmt::format("too many includes; allowed: {} files", limits_.max_files));
    }
    if (open_.size() >= static_cast<std::size_t>(limits_.max_depth)) {
      refuse(place, fmt::format("includes nest too deeply; allowed: {} levels", limits_.max_depth));
    }
    const fs::path file = find_confined(place, name, folder);
    if (std::find(open_.begin(), open_.end(), file) != open_.end()) {
      refuse(place, fmt::format("{} includes itself", quote(name)));
    }
    TreeNode tree = read_yaml(file);
    num_nodes_ += count_nodes(tree);
    if (num_nodes_ > limits_.max_nodes) {
      refuse(place, fmt::format("too many values included; allowed: {}", limits_.max_nodes));
    }
    if (tree.kind == TreeNode::Kind::kNothing) return;
    if (tree.kind != TreeNode::Kind::kMap) refuse(tree.place, "expected a map of keys and values");
    open_.push_back(file);
    resolve(tree, file.parent_path());
    open_.pop_back();
    if (base.kind == TreeNode::Kind::kNothing) {
      base = std::move(tree);
    } else {
      lay_over(base, std::move(tree));
    }
  }

  const IncludeLimits limits_;
  std::vector<fs::path> open_;  // files that are being included, outermost first
  int num_files_ = 0;
  std::size_t num_nodes_ = 0;
};

}  // namespace

std::vector<std::pair<Place, std::string>> include_names(const Value& value) {
  std::vector<std::pair<Place, std::string>> names;
  if (value.node().kind != TreeNode::Kind::kList) return {{value.node().place, value.text()}};
  for (const Value& name : value.items()) names.emplace_back(name.node().place, name.text());
  return names;
}

void resolve_includes(TreeNode& root, const fs::path& folder, const IncludeLimits& limits) {
  Includer(limits).resolve(root, folder);
}

}  // namespace scanbed::scenarios
