// SPDX-License-Identifier: MIT
#include "scenarios/load/number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdio>

namespace scanbed::scenarios {
namespace {

TEST(ParseNumberTest, ReadsPlainDecimals) {
  EXPECT_EQ(parse_number("0"), 0.0);
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("-.25"), -0.25);
  EXPECT_EQ(parse_number("1e-3"), 0.001);
  EXPECT_EQ(parse_number("2.5E+2"), 250.0);
}

TEST(ParseNumberTest, RefusesWhatCouldBeMeantOtherwise) {
  for (const char* text :
       {"",    "-",   "+", "012",  "-012", "0x10", "1_000", "1,5",   "1 m", " 1",   "1 ",
        "--1", "+-1", ".", "-.e1", "nan",  "inf",  "-inf",  "1e999", "1e",  "true", "$R"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(ParseNumberTest, ReadsBackEveryFiniteNumber, (double value)) {
  RC_PRE(std::isfinite(value));
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", value);
  RC_ASSERT(parse_number(text) == value);
}

TEST(ParseCountTest, ReadsDigitsAlone) {
  EXPECT_EQ(parse_count("0"), 0);
  EXPECT_EQ(parse_count("9223372036854775807"), 9223372036854775807);
  for (const char* text : {"", "-1", "+1", "007", ".5", "1.0", "1e3", "9223372036854775808", "x"}) {
    EXPECT_EQ(parse_count(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace scanbed::scenarios
