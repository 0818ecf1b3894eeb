// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace scanbed::hw {

/// A JSON text, parsed. Accessors that meet another kind of value than they want throw InputError that names
/// what they looked for.
class JsonValue {
 public:
  using Array = std::vector<JsonValue>;
  using Object = std::vector<std::pair<std::string, JsonValue>>;
  using Data = std::variant<std::nullptr_t, bool, double, std::string, Array, Object>;

  JsonValue() = default;
  explicit JsonValue(Data data) : data_(std::move(data)) {}

  /// @param name  of the value, for messages.
  double number(std::string_view name) const;  ///< finite
  int integer(std::string_view name) const;
  const std::string& text(std::string_view name) const;
  const Array& array(std::string_view name) const;
  const Object& object(std::string_view name) const;

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(data_); }
  const std::string* if_text() const { return std::get_if<std::string>(&data_); }
  const double* if_number() const { return std::get_if<double>(&data_); }

  /// The member of an object; nullptr where it is missing, null, or this is no object.
  const JsonValue* find(std::string_view key) const;

  /// The member of an object. @throws InputError where find() gives none.
  const JsonValue& at(std::string_view key) const;

 private:
  Data data_ = nullptr;
};

/// Parses exactly one JSON text (RFC 8259), at most 64 levels deep; of members with the same name the first
/// counts. Text is not checked to be UTF-8.
/// @throws InputError "not JSON at byte 17: expected a value".
JsonValue parse_json(std::string_view text);

}  // namespace scanbed::hw
