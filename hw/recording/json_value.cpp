// SPDX-License-Identifier: MIT
#include "hw/recording/json_value.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

constexpr int kMostLevels = 64;

void append_utf8(std::string& out, std::uint32_t code) {
  const auto put = [&out](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0 | (code >> 6));
  } else if (code < 0x10000) {
    put(0xE0 | (code >> 12));
    put(0x80 | ((code >> 6) & 0x3F));
  } else {
    put(0xF0 | (code >> 18));
    put(0x80 | ((code >> 12) & 0x3F));
    put(0x80 | ((code >> 6) & 0x3F));
  }
  put(0x80 | (code & 0x3F));
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  JsonValue parse() {
    JsonValue value = value_at(0);
    skip_blanks();
    if (at_ != text_.size()) fail("expected the end");
    return value;
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw InputError("not JSON at byte " + std::to_string(at_) + ": " + std::string(what));
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_blanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
      ++at_;
  }

  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void need(char c) {
    if (!take(c)) fail(std::string("expected '") + c + "'");
  }

  JsonValue value_at(int level) {
    skip_blanks();
    switch (peek()) {
      case '{':
        return object_at(level + 1);
      case '[':
        return array_at(level + 1);
      case '"':
        return JsonValue(string());
      case 't':
        return word("true", JsonValue(true));
      case 'f':
        return word("false", JsonValue(false));
      case 'n':
        return word("null", JsonValue());
      default:
        return JsonValue(number());
    }
  }

  JsonValue word(std::string_view name, JsonValue value) {
    if (!text_.substr(at_).starts_with(name)) fail("expected a value");
    at_ += name.size();
    return value;
  }

  JsonValue array_at(int level) {
    if (level > kMostLevels) fail("nested too deeply");
    need('[');
    JsonValue::Array items;
    skip_blanks();
    if (take(']')) return JsonValue(std::move(items));
    do {
      items.push_back(value_at(level));
      skip_blanks();
    } while (take(','));
    need(']');
    return JsonValue(std::move(items));
  }

  JsonValue object_at(int level) {
    if (level > kMostLevels) fail("nested too deeply");
    need('{');
    JsonValue::Object members;
    skip_blanks();
    if (take('}')) return JsonValue(std::move(members));
    do {
      skip_blanks();
      std::string key = string();
      skip_blanks();
      need(':');
      members.emplace_back(std::move(key), value_at(level));
      skip_blanks();
    } while (take(','));
    need('}');
    return JsonValue(std::move(members));
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  /// from_chars alone would also read "inf", "nan", "1." and "01".
  std::size_t number_end() {
    std::size_t end = at_;
    const auto digits = [&] {
      const std::size_t first = end;
      while (end < text_.size() && is_digit(text_[end])) ++end;
      if (end == first) fail("expected a value");
    };
    const auto is = [&](std::string_view any) {
      return end < text_.size() && any.find(text_[end]) != std::string_view::npos;
    };
    if (is("-")) ++end;
    if (is("0")) {
      ++end;
    } else {
      digits();
    }
    if (is(".")) {
      ++end;
      digits();
    }
    if (is("eE")) {
      ++end;
      if (is("+-")) ++end;
      digits();
    }
    return end;
  }

  double number() {
    const std::size_t end = number_end();
    double value = 0.0;
    const auto result = std::from_chars(text_.data() + at_, text_.data() + end, value);
    // Out of range is an answer of from_chars for 1e999 and for 1e-999; neither is a number of ours.
    if (result.ec != std::errc()) fail("number out of range");
    at_ = end;
    return value;
  }

  std::uint32_t hex4() {
    std::uint32_t code = 0;
    const std::string_view digits = text_.substr(at_, 4);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 4 || result.ec != std::errc() || result.ptr != digits.data() + 4) {
      fail("expected four hexadecimal digits");
    }
    at_ += 4;
    return code;
  }

  void unicode_escape(std::string& out) {
    std::uint32_t code = hex4();
    if (code >= 0xD800 && code < 0xDC00) {
      need('\\');
      need('u');
      const std::uint32_t low = hex4();
      if (low < 0xDC00 || low > 0xDFFF) fail("half a surrogate pair");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    } else if (code >= 0xDC00 && code < 0xE000) {
      fail("half a surrogate pair");
    }
    append_utf8(out, code);
  }

  void escape(std::string& out) {
    constexpr std::string_view kNames = "\"\\/bfnrt";
    constexpr std::string_view kValues = "\"\\/\b\f\n\r\t";
    if (take('u')) return unicode_escape(out);
    const std::size_t which = kNames.find(peek());
    if (at_ >= text_.size() || which == std::string_view::npos) fail("unknown escape");
    out.push_back(kValues[which]);
    ++at_;
  }

  std::string string() {
    need('"');
    std::string out;
    for (;;) {
      if (at_ >= text_.size()) fail("text without end");
      if (take('"')) return out;
      if (take('\\')) {
        escape(out);
      } else if (static_cast<unsigned char>(text_[at_]) < 0x20) {
        fail("control character in a text");
      } else {
        out.push_back(text_[at_++]);
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

template <class Wanted>
const Wanted& get(const JsonValue::Data& data, std::string_view name, std::string_view kind) {
  if (const auto* const found = std::get_if<Wanted>(&data)) return *found;
  throw InputError(std::string(name) + " is not " + std::string(kind));
}

}  // namespace

double JsonValue::number(std::string_view name) const {
  return get<double>(data_, name, "a number");
}

int JsonValue::integer(std::string_view name) const {
  const double value = number(name);
  // Written so that what fits no int is never cast to one.
  if (std::abs(value) <= 1e9 && value == std::floor(value)) return static_cast<int>(value);
  throw InputError(std::string(name) + " is not a whole number of at most 1e9");
}

const std::string& JsonValue::text(std::string_view name) const {
  return get<std::string>(data_, name, "a text");
}

const JsonValue::Array& JsonValue::array(std::string_view name) const {
  return get<Array>(data_, name, "an array");
}

const JsonValue::Object& JsonValue::object(std::string_view name) const {
  return get<Object>(data_, name, "an object");
}

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto* const members = std::get_if<Object>(&data_);
  if (members == nullptr) return nullptr;
  for (const auto& [name, value] : *members) {
    if (name == key) return value.is_null() ? nullptr : &value;
  }
  return nullptr;
}

const JsonValue& JsonValue::at(std::string_view key) const {
  if (const JsonValue* const found = find(key)) return *found;
  throw InputError("'" + std::string(key) + "' is missing");
}

JsonValue parse_json(std::string_view text) {
  return Parser(text).parse();
}

}  // namespace scanbed::hw
