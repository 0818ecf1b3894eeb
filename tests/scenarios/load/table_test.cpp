// SPDX-License-Identifier: MIT
#include "scenarios/load/table.hpp"

#include <gtest/gtest.h>

#include "scenarios/load/yaml.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

const Variables kNone;

TEST(TableTest, GivesValuesAndFallbacks) {
  const TreeNode root = parse_yaml("a: 1\nb: true\nc: x\n", "f");
  Table table(Value(root, "thing", kNone));
  EXPECT_EQ(table.number("a", 7.0), 1.0);
  EXPECT_EQ(table.number("z", 7.0), 7.0);
  EXPECT_TRUE(table.flag("b", false));
  EXPECT_TRUE(table.flag("y", true));
  EXPECT_EQ(table.text("c", "w"), "x");
  EXPECT_EQ(table.text("v", "w"), "w");
  EXPECT_NO_THROW(table.finish());
}

TEST(TableTest, RefusesAKeyThatNobodyTook) {
  const TreeNode root = parse_yaml("radius: 1\nraduis: 2\n", "f");
  Table table(Value(root, "thing", kNone));
  table.take("radius");
  EXPECT_EQ(error_of([&] { table.finish(); }), "f:2:1: unknown key 'raduis'; did you mean 'radius'?");
}

TEST(TableTest, ListsTheKnownKeysWhereNoneIsNear) {
  const TreeNode root = parse_yaml("friction: 2\n", "f");
  Table table(Value(root, "thing", kNone));
  table.take("at");
  table.take("r");
  EXPECT_EQ(error_of([&] { table.finish(); }), "f:1:1: unknown key 'friction'; known keys: at, r");
}

TEST(TableTest, SaysWhereAMissingKeyBelongs) {
  const TreeNode root = parse_yaml("x:\n  a: 1\n", "f");
  Table table(Value(root.entries[0].value, "x", kNone));
  EXPECT_EQ(error_of([&] { table.need("at"); }), "f:2:3: x: missing key 'at'");
}

TEST(TableTest, NamesTheKeyThatAMissingOneWasMeantBy) {
  const TreeNode root = parse_yaml("x: 1\ndurration: 2\n", "f");
  Table table(Value(root, "thing", kNone));
  EXPECT_EQ(error_of([&] { table.need("duration"); }),
            "f:1:1: thing: missing key 'duration'; did you mean it by 'durration' on line 2?");
}

TEST(TableTest, RefusesWhatIsNoMap) {
  const TreeNode root = parse_yaml("[1]\n", "f");
  EXPECT_EQ(error_of([&] { Table table(Value(root, "thing", kNone)); }),
            "f:1:1: thing: expected a map of keys and values");
}

}  // namespace
}  // namespace scanbed::scenarios
