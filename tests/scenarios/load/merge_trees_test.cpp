// SPDX-License-Identifier: MIT
#include "scenarios/load/merge_trees.hpp"

#include <gtest/gtest.h>

#include "scenarios/load/yaml.hpp"

namespace scanbed::scenarios {
namespace {

// As flow YAML, so that a whole tree can be compared.
std::string to_text(const TreeNode& node) {
  std::string text;
  if (node.kind == TreeNode::Kind::kScalar) return node.text;
  if (node.kind == TreeNode::Kind::kList) {
    for (const TreeNode& item : node.items) text += (text.empty() ? "" : ", ") + to_text(item);
    return "[" + text + "]";
  }
  for (const NodeEntry& entry : node.entries) {
    text += (text.empty() ? "" : ", ") + entry.key + ": " + to_text(entry.value);
  }
  return "{" + text + "}";
}

std::string merged(const std::string& base, const std::string& over) {
  TreeNode tree = parse_yaml(base, "base");
  lay_over(tree, parse_yaml(over, "over"));
  return to_text(tree);
}

TEST(LayOverTest, ReplacesAndAddsKeyByKey) {
  EXPECT_EQ(merged("{a: 1, b: {c: 2, d: 3}}", "{b: {d: 4}, e: 5}"), "{a: 1, b: {c: 2, d: 4}, e: 5}");
  EXPECT_EQ(merged("{a: {b: 1}}", "{a: 2}"), "{a: 2}");
  EXPECT_EQ(merged("{a: 1}", "{a: {b: 2}}"), "{a: {b: 2}}");
}

TEST(LayOverTest, TakesAwayWhatAKeyWithoutAValueNames) {
  EXPECT_EQ(merged("{a: 1, b: {c: 2, d: 3}}", "{a: , b: {c: }}"), "{b: {d: 3}}");
}

TEST(LayOverTest, ReplacesListsOfValues) {
  EXPECT_EQ(merged("{a: [1, 2, 3]}", "{a: [4]}"), "{a: [4]}");
  EXPECT_EQ(merged("{a: [{id: x}]}", "{a: []}"), "{a: []}");
  EXPECT_EQ(merged("{a: [{wait: 1}]}", "{a: [{go: 2}]}"), "{a: [{go: 2}]}");
}

TEST(LayOverTest, LaysElementsWithTheSameIdOverEachOther) {
  EXPECT_EQ(merged("{w: [{id: x, r: 1}, {id: y}]}", "{w: [{id: z}, {id: x, r: 2}]}"),
            "{w: [{id: x, r: 2}, {id: y}, {id: z}]}");
}

TEST(LayOverTest, KeepsTwoOfOneIdWithinAFileForTheLoaderToRefuse) {
  EXPECT_EQ(merged("{w: [{id: y}]}", "{w: [{id: x}, {id: x}]}"), "{w: [{id: y}, {id: x}, {id: x}]}");
}

TEST(LayOverTest, RemembersWhereEachValueStood) {
  TreeNode tree = parse_yaml("{a: 1, b: 2}", "base");
  lay_over(tree, parse_yaml("{b: 3}", "over"));
  EXPECT_EQ(tree.entries[0].value.place.source->name, "base");
  EXPECT_EQ(tree.entries[1].value.place.source->name, "over");
}

}  // namespace
}  // namespace scanbed::scenarios
