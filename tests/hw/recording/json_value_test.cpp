// SPDX-License-Identifier: MIT
#include "hw/recording/json_value.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/errors/input_error.hpp"
#include "core/text/utf8.hpp"
#include "hw/recording/json_text.hpp"

namespace scanbed::hw {
namespace {

TEST(JsonValueTest, ReadsEachKind) {
  const JsonValue json = parse_json(R"( {"n": -1.5e2, "t": "a", "b": [true, false, null], "o": {"x": 0}} )");
  EXPECT_EQ(json.at("n").number("n"), -150.0);
  EXPECT_EQ(json.at("t").text("t"), "a");
  EXPECT_EQ(json.at("b").array("b").size(), 3U);
  EXPECT_EQ(json.at("o").at("x").integer("x"), 0);
  EXPECT_EQ(json.object("json").size(), 4U);
}

TEST(JsonValueTest, ReadsEscapes) {
  EXPECT_EQ(parse_json(R"("\"\\\/\b\f\n\r\t\u0041\u00e4\u20ac\ud83d\ude00")").text("text"),
            "\"\\/\b\f\n\r\tA\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
}

// From the grammar of RFC 8259.
TEST(JsonValueTest, RefusesWhatIsNoJson) {
  for (const char* text : {"",
                           " ",
                           "{",
                           "}",
                           "[",
                           "[1",
                           "[1,",
                           "[1,]",
                           "[,1]",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{\"a\":1,}",
                           "{a:1}",
                           "01",
                           "+1",
                           "1.",
                           ".5",
                           "1e",
                           "-",
                           "nan",
                           "inf",
                           "-inf",
                           "Infinity",
                           "0x10",
                           "tru",
                           "nul",
                           "\"",
                           "\"a",
                           "\"\\x\"",
                           "\"\\u12\"",
                           "\"\\ud800\"",
                           "\"\\udc00\"",
                           "\"\\ud800\\u0041\"",
                           "\"\n\"",
                           "1 2",
                           "[] []",
                           "1e999",
                           "'a'"}) {
    EXPECT_THROW(parse_json(text), InputError) << text;
  }
}

TEST(JsonValueTest, RefusesDeepNesting) {
  EXPECT_NO_THROW(parse_json(std::string(64, '[') + std::string(64, ']')));
  EXPECT_THROW(parse_json(std::string(65, '[') + std::string(65, ']')), InputError);
  EXPECT_THROW(parse_json(std::string(1'000'000, '[')), InputError);
}

TEST(JsonValueTest, NamesWhatIsMissingOrOfAnotherKind) {
  const JsonValue json = parse_json(R"({"a": null, "b": "x", "c": 1.5, "d": 1e10})");
  EXPECT_EQ(json.find("a"), nullptr);
  EXPECT_EQ(json.find("z"), nullptr);
  EXPECT_EQ(json.at("b").find("x"), nullptr);
  EXPECT_THROW(json.at("a"), InputError);
  EXPECT_THROW(json.at("b").number("b"), InputError);
  EXPECT_THROW(json.at("c").text("c"), InputError);
  EXPECT_THROW(json.at("c").integer("c"), InputError);
  EXPECT_THROW(json.at("d").integer("d"), InputError);
  EXPECT_THROW(json.array("json"), InputError);
}

RC_GTEST_PROP(JsonValueTest, AnyTextComesBack, (const std::string& bytes)) {
  const std::string text = as_utf8(bytes);
  std::string out;
  JsonText(out).text(text);
  RC_ASSERT(parse_json(out).text("text") == text);
}

RC_GTEST_PROP(JsonValueTest, AnyBytesAreJsonOrRefused, (const std::string& text)) {
  try {
    parse_json(text);
  } catch (const InputError& error) {
    RC_ASSERT(std::string(error.what()).starts_with("not JSON at byte "));
  }
}

}  // namespace
}  // namespace scanbed::hw
