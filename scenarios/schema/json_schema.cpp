// SPDX-License-Identifier: MIT
#include "scenarios/schema/json_schema.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

namespace scanbed::scenarios {
namespace {

using Json = nlohmann::ordered_json;
using Form = Asked::Form;

constexpr const char* kInclude = "include";

Json to_json(double value) {
  // 360, not 360.0.
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

/// Writes schemas of values; a file that includes others need not have any key.
class SchemaWriter {
 public:
  explicit SchemaWriter(bool needs_keys) : needs_keys_(needs_keys) {}

  Json schema(const Asked& asked) const {
    Json forms = Json::array();
    for (const Form form : asked.forms()) {
      // A whole number that may be any number is no form of its own.
      if (form == Form::kCount && asked.has(Form::kNumber)) continue;
      forms.push_back(schema(asked, form));
      if (form == Form::kNumber || form == Form::kCount) forms.push_back({{"$ref", "#/$defs/arithmetic"}});
    }
    if (forms.empty()) return Json::object();
    return forms.size() == 1 ? forms.front() : Json{{"anyOf", forms}};
  }

 private:
  Json schema(const Asked& asked, Form form) const {
    switch (form) {
      case Form::kNumber:
        return number(asked, "number");
      case Form::kCount:
        return number(asked, "integer");
      case Form::kFlag:
        return {{"type", "boolean"}};
      case Form::kText:
        // What editors read as a number or a flag, the loader takes as it is written: id: 7.
        return {{"type", {"string", "number", "boolean"}}, {"minLength", 1}};
      case Form::kWord:
        return {{"enum", asked.words()}};
      case Form::kList:
        return list(asked);
      case Form::kMap:
        return map(asked);
    }
    return {};
  }

  static Json number(const Asked& asked, const char* type) {
    const Allowed& allowed = asked.allowed();
    Json json = {{"type", type}};
    if (std::isfinite(allowed.least)) {
      json[allowed.open ? "exclusiveMinimum" : "minimum"] = to_json(allowed.least);
    }
    if (std::isfinite(allowed.greatest)) json["maximum"] = to_json(allowed.greatest);
    return json;
  }

  Json list(const Asked& asked) const {
    Json json = {{"type", "array"}};
    if (asked.items() != nullptr) json["items"] = schema(*asked.items());
    if (asked.least_items() > 0) json["minItems"] = asked.least_items();
    if (asked.greatest_items() < std::numeric_limits<std::size_t>::max()) {
      json["maxItems"] = asked.greatest_items();
    }
    return json;
  }

  Json map(const Asked& asked) const {
    Json json = {{"type", "object"}};
    if (asked.any_keys() != nullptr) {
      json["additionalProperties"] = schema(*asked.any_keys());
      return json;
    }
    Json properties = Json::object();
    Json required = Json::array();
    for (const std::string& key : asked.key_names()) {
      properties[key] = is_needless(key) ? or_nothing(schema(asked.key(key))) : schema(asked.key(key));
      if (needs_keys_ && asked.is_needed(key)) required.push_back(key);
    }
    json["properties"] = properties;
    if (!required.empty()) json["required"] = required;
    json["additionalProperties"] = false;
    return json;
  }

  // A key without a value takes that of the included file away; includes are followed before.
  bool is_needless(const std::string& key) const { return !needs_keys_ && key != kInclude; }

  static Json or_nothing(const Json& json) {
    Json forms = json.contains("anyOf") ? json["anyOf"] : Json::array({json});
    forms.push_back({{"type", "null"}});
    return {{"anyOf", forms}};
  }

  bool needs_keys_;
};

}  // namespace

std::string json_schema(const Asked& scenario) {
  const Json arithmetic = {{"description", "arithmetic over numbers and vars: $R * 2 + 0.1"},
                           {"type", "string"},
                           {"minLength", 1}};
  const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                       {"title", "scanbed scenario"},
                       {"if", {{"required", {kInclude}}}},
                       {"then", {{"$ref", "#/$defs/part"}}},
                       {"else", {{"$ref", "#/$defs/whole"}}},
                       {"$defs",
                        {{"arithmetic", arithmetic},
                         {"whole", SchemaWriter(true).schema(scenario)},
                         {"part", SchemaWriter(false).schema(scenario)}}}};
  return schema.dump(2) + "\n";
}

}  // namespace scanbed::scenarios
