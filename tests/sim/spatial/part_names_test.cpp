// SPDX-License-Identifier: MIT
#include "sim/spatial/part_names.hpp"

#include <gtest/gtest.h>

#include <set>

namespace scanbed::sim {
namespace {

TEST(PartNamesTest, NamesSayKindIdAndPart) {
  EXPECT_EQ(solid_name("hall", 2), "solid/hall/2");
  EXPECT_EQ(walker_name("student_A", "left_shank"), "walker/student_A/left_shank");
  EXPECT_EQ(tow_name("cyl", "rope"), "tow/cyl/rope");
}

TEST(PartNamesTest, IdsThatLookLikePartsDoNotCollide) {
  const std::set<std::string> names{
      solid_name("a", 0),    solid_name("a/0", 0),    solid_name("", 0),  solid_name("walker/a", 0),
      walker_name("a", "0"), walker_name("a/0", "0"), tow_name("a", "0"), tow_name("solid/a", "0")};
  EXPECT_EQ(names.size(), 8U);
}

TEST(PartNamesTest, ControlCharactersAreSpelledOut) {
  EXPECT_EQ(solid_name(std::string_view("a\0b\n\x7f", 5), 0), "solid/a\\x00b\\x0a\\x7f/0");
}

}  // namespace
}  // namespace scanbed::sim
