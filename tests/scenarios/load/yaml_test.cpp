// SPDX-License-Identifier: MIT
#include "scenarios/load/yaml.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

std::string yaml_error(std::string_view text, const YamlLimits& limits = {}) {
  return error_of([&] { parse_yaml(text, "f", limits); });
}

TEST(ParseYamlTest, KeepsTextPlaceAndOrder) {
  const TreeNode root = parse_yaml("b: 012\na: [no, 'no', \"1\"]\n", "f");
  ASSERT_EQ(root.kind, TreeNode::Kind::kMap);
  ASSERT_EQ(root.entries.size(), 2u);
  EXPECT_EQ(root.entries[0].key, "b");
  EXPECT_EQ(root.entries[0].value.text, "012");  // neither 10 nor 12: text until somebody reads it
  EXPECT_EQ(to_string(root.entries[0].value.place), "f:1:4");
  EXPECT_EQ(to_string(root.entries[1].place), "f:2:1");
  const TreeNode& list = root.entries[1].value;
  ASSERT_EQ(list.items.size(), 3u);
  EXPECT_FALSE(list.items[0].is_quoted);
  EXPECT_TRUE(list.items[1].is_quoted);
  EXPECT_TRUE(list.items[2].is_quoted);
  EXPECT_EQ(to_string(list.items[1].place), "f:2:9");
}

TEST(ParseYamlTest, ReadsAnEmptyTextAsNothing) {
  EXPECT_EQ(parse_yaml("", "f").kind, TreeNode::Kind::kNothing);
  EXPECT_EQ(parse_yaml("# only a comment\n", "f").kind, TreeNode::Kind::kNothing);
  EXPECT_EQ(parse_yaml("a:\n", "f").entries[0].value.kind, TreeNode::Kind::kNothing);
}

TEST(ParseYamlTest, CopiesAnAlias) {
  const TreeNode root = parse_yaml("a: &x [1, 2]\nb: *x\n", "f");
  ASSERT_EQ(root.entries[1].value.items.size(), 2u);
  EXPECT_EQ(root.entries[1].value.items[1].text, "2");
}

TEST(ParseYamlTest, RefusesDuplicateKeysAtTheSecond) {
  EXPECT_EQ(yaml_error("a: 1\nb: 2\na: 3\n"), "f:3:1: duplicate key 'a'; first on line 1");
  EXPECT_EQ(yaml_error("m: {x: 1, x: 1}\n"), "f:1:11: duplicate key 'x'; first on line 1");
}

TEST(ParseYamlTest, RefusesBrokenSyntaxWithItsPlace) {
  EXPECT_TRUE(yaml_error("a: [1, 2\n").starts_with("f:2:1: not valid YAML: ")) << yaml_error("a: [1, 2\n");
  EXPECT_TRUE(yaml_error("a: 1\n b: 2\n").starts_with("f:2:")) << yaml_error("a: 1\n b: 2\n");
  EXPECT_TRUE(yaml_error("a: *nobody\n").starts_with("f:1:")) << yaml_error("a: *nobody\n");
}

// The library gives what it read until the file's end.
TEST(ParseYamlTest, RefusesAQuotationWithoutEndWhereItBegins) {
  for (const std::string quote : {"\"", "'"}) {
    const std::string open = "c: 0\na: " + quote + "two columns\nb: 1\n";
    EXPECT_EQ(yaml_error(open), "f:2:4: not valid YAML: the quotation that begins here has no end");
    EXPECT_EQ(parse_yaml("a: " + quote + "two\n  lines" + quote + "\n", "f").entries[0].value.text,
              "two lines");
  }
  EXPECT_EQ(parse_yaml("a: 'x'\n...\n", "f").entries.size(), 1U);
}

TEST(ParseYamlTest, RefusesWhatAScenarioNeverNeeds) {
  EXPECT_EQ(yaml_error("a: !!int 3\n"), "f:1:4: tags are not supported");
  EXPECT_EQ(yaml_error("a: !x [3]\n"), "f:1:4: tags are not supported");
  EXPECT_EQ(yaml_error("[1, 2]: 3\n"), "f:1:1: a key must be plain text");
  EXPECT_EQ(yaml_error("a: 1\n---\nb: 2\n"), "f:3:1: a second document; a file holds one");
  EXPECT_EQ(yaml_error("a: &x [1, *x]\n"), "f:1:11: an alias within its own anchor");
}

TEST(ParseYamlTest, RefusesTextThatIsNotUtf8) {
  EXPECT_EQ(yaml_error("a: 1\nb: caf\xE9\n"), "f:2:4: is no text in UTF-8; save the file as UTF-8");
  EXPECT_EQ(parse_yaml("b: caf\xC3\xA9\n", "f").entries[0].value.text, "caf\xC3\xA9");
}

TEST(ParseYamlTest, BoundsDepth) {
  const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(yaml_error(nested(24)), "");
  EXPECT_EQ(yaml_error(nested(25)), "f:1:25: nested too deeply; allowed: 24 levels");
  EXPECT_NE(yaml_error(nested(100'000)), "");
  EXPECT_NE(yaml_error(std::string(100'000, '[')), "");
  EXPECT_NE(yaml_error(std::string(100'000, '{')), "");
}

TEST(ParseYamlTest, BoundsAliasBombs) {
  // Nine levels of nine copies each would be 387 million values.
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int j = 0; j < 9; ++j) bomb += (j > 0 ? ", " : "") + last;
    bomb += "]\n";
  }
  EXPECT_NE(yaml_error(bomb).find("too many values; allowed: 20000"), std::string::npos) << yaml_error(bomb);
}

TEST(ParseYamlTest, BoundsSize) {
  const YamlLimits limits{.max_bytes = 1024};
  EXPECT_EQ(yaml_error(std::string(1024, '#'), limits), "");
  EXPECT_EQ(yaml_error(std::string(1025, '#'), limits), "f: file is too large; allowed: 1 KiB");
}

RC_GTEST_PROP(ParseYamlTest, ParsesOrRefusesAnyText, (const std::string& text)) {
  const std::string error = yaml_error(text);
  RC_ASSERT(error.empty() || error.starts_with("f"));
}

TEST(ReadYamlTest, ReadsAFile) {
  const testing::TemporaryFolder folder;
  const auto path = testing::write_file(folder / "a.yaml", "a: 1\n");
  const TreeNode root = read_yaml(path);
  EXPECT_EQ(to_string(root.entries[0].value.place), path.string() + ":1:4");
}

TEST(ReadYamlTest, RefusesWhatIsNoReadableFile) {
  const testing::TemporaryFolder folder;
  const std::string missing = (folder / "none.yaml").string();
  EXPECT_EQ(error_of([&] { read_yaml(missing); }), missing + ": no such file");
  EXPECT_EQ(error_of([&] { read_yaml(folder.path()); }),
            folder.path().string() + ": is a folder, not a file");
  EXPECT_EQ(error_of([&] { read_yaml("/dev/zero"); }), "/dev/zero: file is too large; allowed: 256 KiB");
}

}  // namespace
}  // namespace scanbed::scenarios
