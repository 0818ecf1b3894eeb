// SPDX-License-Identifier: MIT
#include "hw/recording/json_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hw/recording/json_value.hpp"

namespace scanbed::hw {
namespace {

TEST(JsonTextTest, PutsCommasWhereTheyBelong) {
  std::string out;
  JsonText json(out);
  json.begin_object().key("a").begin_array().end_array().key("b").begin_array().integer(1).number(0.5);
  json.begin_object().end_object().text("x").end_array().key("c").text("").end_object();
  EXPECT_EQ(out, R"({"a":[],"b":[1,0.5,{},"x"],"c":""})");
}

TEST(JsonTextTest, NumbersReadBackToTheSameDouble) {
  for (const double value : {0.0, -0.0, 1.0 / 3.0, 1e300, 5e-324, -2.5, 1234567890123.0}) {
    std::string out;
    JsonText(out).number(value);
    if (std::abs(value) < 1e-300 && value != 0.0) continue;  // read as out of range: see parse_json
    EXPECT_EQ(parse_json(out).number("value"), value) << out;
  }
}

// JSON has no such numbers, and what is written must stay JSON.
TEST(JsonTextTest, WhatIsNoNumberIsReplaced) {
  std::string out;
  JsonText(out).begin_array().number(std::nan("")).number(HUGE_VAL).number(-HUGE_VAL).end_array();
  const JsonValue::Array items = parse_json(out).array("items");
  EXPECT_EQ(items[0].number("nan"), 0.0);
  EXPECT_GT(items[1].number("inf"), 1e308);
  EXPECT_LT(items[2].number("-inf"), -1e308);
}

TEST(JsonTextTest, EscapesWhatMustNotStandInATextAsItIs) {
  std::string out;
  const std::string text = std::string("\"\\\n\x01/") + '\0' + "\xc3\xa4";
  JsonText(out).text(text);
  EXPECT_EQ(out, "\"\\\"\\\\\\u000a\\u0001/\\u0000\xc3\xa4\"");
  EXPECT_EQ(parse_json(out).text("text"), text);
}

TEST(JsonTextTest, ReplacesWhatIsNoUtf8) {
  std::string out;
  JsonText(out).begin_object().key("a\xff").text("\xc3\xa4\xc3").end_object();
  EXPECT_EQ(out, "{\"a\xef\xbf\xbd\":\"\xc3\xa4\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace scanbed::hw
