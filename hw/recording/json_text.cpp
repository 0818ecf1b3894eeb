// SPDX-License-Identifier: MIT
#include "hw/recording/json_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/text/utf8.hpp"

namespace scanbed::hw {
namespace {

template <class Value>
void append_json_number(std::string& out, Value value) {
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), result.ptr);
}

void append_quoted(std::string& out, std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out.push_back('"');
  for (const char c : as_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out.push_back('\\');
      out.push_back(c);
    } else if (code < 0x20) {
      out.append("\\u00").push_back(kHex[code >> 4]);
      out.push_back(kHex[code & 15]);
    } else {
      out.push_back(c);
    }
  }
  out.push_back('"');
}

}  // namespace

void JsonText::separate() {
  if (!is_first_) out_.push_back(',');
  is_first_ = false;
}

JsonText& JsonText::begin(char bracket) {
  separate();
  out_.push_back(bracket);
  is_first_ = true;
  return *this;
}

JsonText& JsonText::end(char bracket) {
  out_.push_back(bracket);
  is_first_ = false;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  separate();
  append_quoted(out_, name);
  out_.push_back(':');
  is_first_ = true;
  return *this;
}

JsonText& JsonText::number(double value) {
  constexpr double kGreatest = std::numeric_limits<double>::max();
  separate();
  append_json_number(out_, std::isnan(value) ? 0.0 : std::clamp(value, -kGreatest, kGreatest));
  return *this;
}

JsonText& JsonText::integer(std::int64_t value) {
  separate();
  append_json_number(out_, value);
  return *this;
}

JsonText& JsonText::text(std::string_view value) {
  separate();
  append_quoted(out_, value);
  return *this;
}

}  // namespace scanbed::hw
