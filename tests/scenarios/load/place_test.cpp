// SPDX-License-Identifier: MIT
#include "scenarios/load/place.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

const auto kFile = std::make_shared<const Source>(Source{"hall.yaml"});

TEST(PlaceTest, NamesFileLineAndColumn) {
  EXPECT_EQ(to_string(Place{kFile, 3, 14}), "hall.yaml:3:14");
  EXPECT_EQ(to_string(Place{kFile, 0, 0}), "hall.yaml");
  EXPECT_EQ(to_string(Place{}), "input");
}

TEST(RefuseTest, ThrowsAnInputErrorThatBeginsWithThePlace) {
  EXPECT_EQ(testing::error_of([] { refuse({kFile, 3, 14}, "no"); }), "hall.yaml:3:14: no");
}

TEST(RefuseTest, KeepsAMessageOnOneLineWhateverItRepeats) {
  EXPECT_EQ(testing::error_of([] { refuse({kFile, 3, 14}, "key a\nb\x1b"); }), "hall.yaml:3:14: key a?b?");
}

TEST(QuoteTest, KeepsAMessageOnOneShortLine) {
  EXPECT_EQ(quote("raduis"), "'raduis'");
  EXPECT_EQ(quote(""), "''");
  EXPECT_EQ(quote("a\nb\x1b[31m\x7f"), "'a?b?[31m?'");
  EXPECT_EQ(quote(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
  EXPECT_EQ(quote(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'");
}

}  // namespace
}  // namespace scanbed::scenarios
