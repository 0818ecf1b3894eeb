// SPDX-License-Identifier: MIT
#include "scenarios/load/set_path.hpp"

#include <gtest/gtest.h>

#include "scenarios/load/yaml.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

TEST(ParseSettingTest, SplitsAtTheFirstEqualsSign) {
  const Setting setting = parse_setting("a.b=c=d");
  EXPECT_EQ(setting.path, "a.b");
  EXPECT_EQ(setting.value, "c=d");
  EXPECT_EQ(parse_setting("a=").value, "");
}

TEST(ParseSettingTest, RefusesWhatIsNoSetting) {
  EXPECT_EQ(error_of([] { parse_setting("seed"); }), "--set: expected PATH=VALUE, found 'seed'");
  EXPECT_EQ(error_of([] { parse_setting("=3"); }), "--set: expected PATH=VALUE, found '=3'");
}

TEST(SetPathTest, ReplacesAValue) {
  TreeNode root = parse_yaml("seed: 1\nsensor: {height: 0.28}\n", "f");
  set_path(root, {"sensor.height", "0.3"});
  const TreeNode& height = root.entries[1].value.entries[0].value;
  EXPECT_EQ(height.text, "0.3");
  EXPECT_EQ(to_string(height.place), "--set sensor.height=0.3");
}

TEST(SetPathTest, MakesMapsThatAreMissing) {
  TreeNode root = parse_yaml("seed: 1\n", "f");
  set_path(root, {"sensor.noise.sigma", "0"});
  ASSERT_EQ(root.entries.size(), 2u);
  EXPECT_EQ(root.entries[1].value.entries[0].value.entries[0].value.text, "0");
}

TEST(SetPathTest, FindsListElementsByIdAndIndex) {
  TreeNode root = parse_yaml("world: [{id: a, r: 1}, {id: b, r: 2}]\n", "f");
  set_path(root, {"world.b.r", "3"});
  set_path(root, {"world.0.r", "4"});
  const std::vector<TreeNode>& items = root.entries[0].value.items;
  EXPECT_EQ(items[0].entries[1].value.text, "4");
  EXPECT_EQ(items[1].entries[1].value.text, "3");
}

TEST(SetPathTest, TakesAnyYamlAsValue) {
  TreeNode root;
  set_path(root, {"robot.pose", "[0, 1, 90]"});
  EXPECT_EQ(root.entries[0].value.entries[0].value.items.size(), 3u);
}

TEST(SetPathTest, RefusesPathsThatLeadNowhere) {
  TreeNode root = parse_yaml("seed: 1\nworld: [{id: col_L}]\n", "f");
  EXPECT_EQ(error_of([&] {
              set_path(root, {"seed.x", "1"});
            }),
            "--set seed.x=1: cannot go into a single value at 'x'");
  EXPECT_EQ(error_of([&] {
              set_path(root, {"world.col_R.r", "1"});
            }),
            "--set world.col_R.r=1: no element 'col_R' among 1; did you mean 'col_L'?");
  EXPECT_EQ(error_of([&] {
              set_path(root, {"world.7.r", "1"});
            }),
            "--set world.7.r=1: no element '7' among 1; known ids: col_L");
  EXPECT_NE(error_of([&] {
              set_path(root, {std::string(100'000, '.'), "1"});
            }).find("path is too long"),
            std::string::npos);
  EXPECT_NE(error_of([&] { set_path(root, {"seed", "[1"}); }).find("not valid YAML"), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
