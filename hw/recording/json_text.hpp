// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// Writes a JSON text front to back into a string: keys and values in turn, commas by itself. Numbers are
/// the shortest that read back to the same double.
class JsonText {
 public:
  /// Appends to `out`, which must outlive it.
  explicit JsonText(std::string& out) : out_(out) {}

  JsonText& begin_object() { return begin('{'); }
  JsonText& begin_array() { return begin('['); }
  JsonText& end_object() { return end('}'); }
  JsonText& end_array() { return end(']'); }

  JsonText& key(std::string_view name);
  /// JSON has nothing for infinities (the greatest number stands in for them) and NaN (0 does).
  JsonText& number(double value);
  JsonText& integer(std::int64_t value);
  /// As for keys: U+FFFD stands in for bytes that are no UTF-8.
  JsonText& text(std::string_view value);

 private:
  JsonText& begin(char bracket);
  JsonText& end(char bracket);
  void separate();

  std::string& out_;
  bool is_first_ = true;  // of the object or array that is open
};

}  // namespace scanbed::hw
