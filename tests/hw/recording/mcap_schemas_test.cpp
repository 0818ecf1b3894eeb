// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_schemas.hpp"

#include <gtest/gtest.h>

#include "hw/recording/json_value.hpp"

namespace scanbed::hw {
namespace {

/// What viewers convert: each property of one kind; no array directly in an array.
void check_kinds(const JsonValue& schema, const std::string& where) {
  const std::string& type = schema.at("type").text(where);
  if (type == "object") {
    for (const auto& [name, property] : schema.at("properties").object(where)) {
      check_kinds(property, where + "." + name);
    }
  } else if (type == "array") {
    EXPECT_NE(schema.at("items").at("type").text(where), "array") << where;
    check_kinds(schema.at("items"), where + "[]");
  } else {
    EXPECT_TRUE(type == "string" || type == "number" || type == "integer" || type == "boolean") << where;
  }
}

TEST(McapSchemasTest, AreJsonOfTheKindsThatViewersConvert) {
  for (const McapSchema& schema : kMcapSchemas) {
    const JsonValue json = parse_json(schema.text);
    EXPECT_EQ(json.at("title").text("title"), schema.name);
    check_kinds(json, std::string(schema.name));
    for (const JsonValue& name : json.at("required").array("required")) {
      EXPECT_NE(json.at("properties").find(name.text("required")), nullptr) << schema.name;
    }
  }
}

}  // namespace
}  // namespace scanbed::hw
