// SPDX-License-Identifier: MIT
#include "hw/recording/field_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include "hw/recording/nano_time.hpp"

namespace scanbed::hw {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// A field as it may stand in a message: short, and without what would garble a terminal.
std::string quoted(std::string_view field) {
  constexpr std::size_t kMostShown = 32;
  std::string shown(field.substr(0, kMostShown));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + shown + (field.size() > kMostShown ? "...'" : "'");
}

/// The whole field as a value; nothing if a character is left over or the value does not fit.
template <class Value>
std::optional<Value> parse(std::string_view field) {
  // from_chars knows no plus sign; printf's "%+f" writes one.
  if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
  Value value{};
  const char* const end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

std::string_view FieldReader::word() {
  const auto* const begin = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
  const auto* const end = std::find_if(begin, rest_.end(), is_blank);
  rest_ = rest_.substr(static_cast<std::size_t>(end - rest_.begin()));
  return {begin, static_cast<std::size_t>(end - begin)};
}

double FieldReader::number(std::string_view name) {
  const std::string_view field = word();
  if (const auto value = parse<double>(field)) return *value;
  fail(std::string(name) + " is " + (field.empty() ? "missing" : quoted(field) + ", not a number"));
  return std::numeric_limits<double>::quiet_NaN();
}

double FieldReader::finite(std::string_view name) {
  const double value = number(name);
  if (!std::isfinite(value)) fail(std::string(name) + " is not finite");
  return value;
}

double FieldReader::time(std::string_view name) {
  const double value = finite(name);
  if (!is_time(value)) fail(std::string(name) + " is more than 1e12 s away from 0");
  return value;
}

int FieldReader::count(std::string_view name) {
  const auto value = peek_count();
  const std::string_view field = word();
  if (value) return *value;
  fail(std::string(name) + " is " + (field.empty() ? "missing" : quoted(field) + ", not a count"));
  return 0;
}

std::optional<int> FieldReader::peek_count() const {
  const auto value = parse<int>(FieldReader(*this).word());
  return value && *value >= 0 ? value : std::nullopt;
}

int FieldReader::num_left() const {
  int num = 0;
  bool was_blank = true;
  for (const char c : rest_) {
    num += static_cast<int>(was_blank && !is_blank(c));
    was_blank = is_blank(c);
  }
  return num;
}

void FieldReader::fail(std::string what) {
  if (failure_.empty()) failure_ = std::move(what);
}

}  // namespace scanbed::hw
