// SPDX-License-Identifier: MIT
#include "scenarios/schema/json_schema.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace scanbed::scenarios {
namespace {

using Form = Asked::Form;
using nlohmann::json;

Asked small() {
  Asked asked;
  asked.add_form(Form::kMap);
  asked.key("r").add_number(Form::kNumber, {.least = 0.0, .greatest = 2.5, .open = true});
  asked.key("n").add_number(Form::kCount, {.least = 1.0});
  asked.key("use").add_words({"a", "b"});
  asked.key("at").add_list(2, 2);
  asked.key("at").item().add_number(Form::kNumber, {});
  asked.key("vars").add_form(Form::kMap);
  asked.key("vars").any_key().add_form(Form::kFlag);
  asked.add_whole_map({"r"});
  return asked;
}

TEST(JsonSchemaTest, SaysWhatWasAsked) {
  const json schema = json::parse(json_schema(small()));
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  const json whole = schema["$defs"]["whole"];
  const json arithmetic = {{"$ref", "#/$defs/arithmetic"}};
  EXPECT_EQ(whole["required"], json({"r"}));
  EXPECT_EQ(whole["additionalProperties"], false);
  const json& keys = whole["properties"];
  EXPECT_EQ(keys.size(), 5u);
  EXPECT_EQ(keys["r"]["anyOf"][0], json({{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 2.5}}));
  EXPECT_EQ(keys["r"]["anyOf"][1], arithmetic);
  EXPECT_EQ(keys["n"]["anyOf"][0], json({{"type", "integer"}, {"minimum", 1}}));
  EXPECT_EQ(keys["use"], json({{"enum", {"a", "b"}}}));
  EXPECT_EQ(keys["at"]["minItems"], 2);
  EXPECT_EQ(keys["at"]["maxItems"], 2);
  EXPECT_EQ(keys["vars"]["additionalProperties"], json({{"type", "boolean"}}));
}

TEST(JsonSchemaTest, FilesThatIncludeOthersNeedNoKey) {
  const json schema = json::parse(json_schema(small()));
  EXPECT_EQ(schema["if"], json({{"required", {"include"}}}));
  EXPECT_FALSE(schema["$defs"]["part"].contains("required"));
  const json& part = schema["$defs"]["part"]["properties"];
  const json& whole = schema["$defs"]["whole"]["properties"];
  ASSERT_EQ(part.size(), whole.size());
  for (const auto& [key, value] : whole.items()) EXPECT_TRUE(part.contains(key)) << key;
}

TEST(JsonSchemaTest, FilesThatIncludeOthersMayTakeAKeyAway) {
  const json schema = json::parse(json_schema(small()));
  const json nothing = {{"type", "null"}};
  const json& part = schema["$defs"]["part"]["properties"];
  EXPECT_EQ(part["r"]["anyOf"].back(), nothing);
  EXPECT_EQ(part["use"]["anyOf"], json({{{"enum", {"a", "b"}}}, nothing}));
  EXPECT_EQ(part["vars"]["anyOf"].back(), nothing);
  EXPECT_EQ(schema["$defs"]["whole"].dump().find("null"), std::string::npos);
}

TEST(JsonSchemaTest, TextMayLookLikeANumberOrAFlag) {
  Asked asked = small();
  asked.key("id").add_form(Form::kText);
  const json schema = json::parse(json_schema(asked));
  const json& id = schema["$defs"]["whole"]["properties"]["id"];
  EXPECT_EQ(id, json({{"type", {"string", "number", "boolean"}}, {"minLength", 1}}));
}

}  // namespace
}  // namespace scanbed::scenarios
