// SPDX-License-Identifier: MIT
#include "scenarios/load/nearest_name.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace scanbed::scenarios {
namespace {

const std::vector<std::string> kKeys = {"at", "radius", "center", "overlap"};

TEST(EditDistanceTest, CountsInsertedDroppedChangedAndSwappedLetters) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("radius", "radius"), 0);
  EXPECT_EQ(edit_distance("radiu", "radius"), 1);
  EXPECT_EQ(edit_distance("rradius", "radius"), 1);
  EXPECT_EQ(edit_distance("rodius", "radius"), 1);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

RC_GTEST_PROP(EditDistanceTest, IsSymmetricAndBoundedByTheLengths,
              (const std::string& a, const std::string& b)) {
  const int distance = edit_distance(a, b);
  RC_ASSERT(distance == edit_distance(b, a));
  RC_ASSERT((distance == 0) == (a == b));
  const int longer = static_cast<int>(std::max(a.size(), b.size()));
  const int shorter = static_cast<int>(std::min(a.size(), b.size()));
  RC_ASSERT(distance >= longer - shorter);
  RC_ASSERT(distance <= longer);
}

TEST(NearestNameTest, FindsTheMisspeltKey) {
  EXPECT_EQ(nearest_name("raduis", kKeys), "radius");
  EXPECT_EQ(nearest_name("centre", kKeys), "center");
  EXPECT_EQ(nearest_name("ta", kKeys), "at");
}

TEST(NearestNameTest, LettersOfAnotherCaseAreNearest) {
  const std::vector<std::string> known = {"D", "s", "R"};
  EXPECT_EQ(nearest_name("r", known), "R");
  EXPECT_EQ(nearest_name("S", known), "s");
}

TEST(NearestNameTest, FindsNothingForAFarWord) {
  EXPECT_EQ(nearest_name("friction", kKeys), std::nullopt);
  EXPECT_EQ(nearest_name("", {}), std::nullopt);
  EXPECT_EQ(near_name_hint("friction", kKeys), "");
  EXPECT_EQ(near_name_hint("raduis", kKeys), "; did you mean 'radius'?");
  EXPECT_EQ(nearest_name(std::string(100'000, 'r'), kKeys), std::nullopt);
}

TEST(NameHintTest, NamesTheNearestOrAll) {
  EXPECT_EQ(name_hint("raduis", kKeys, "keys"), "; did you mean 'radius'?");
  EXPECT_EQ(name_hint("friction", kKeys, "keys"), "; known keys: at, radius, center, overlap");
  EXPECT_EQ(name_hint("R", {}, "variables"), "; there are no known variables");
}

}  // namespace
}  // namespace scanbed::scenarios
