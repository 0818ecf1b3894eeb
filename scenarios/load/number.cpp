// SPDX-License-Identifier: MIT
#include "scenarios/load/number.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "scenarios/load/is_digit.hpp"

namespace scanbed::scenarios {
namespace {

// "0", "0.5", ".5" and "12" are fine; "012" is not, as half of the world reads it as octal.
bool starts_like_a_number(std::string_view digits) {
  if (digits.size() > 1 && digits[0] == '.') return is_digit(digits[1]);
  if (digits.empty() || !is_digit(digits[0])) return false;
  return !(digits[0] == '0' && digits.size() > 1 && is_digit(digits[1]));
}

template <typename T>
std::optional<T> parse_whole_text(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const bool has_sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  const std::string_view digits = text.substr(has_sign ? 1 : 0);
  if (!starts_like_a_number(digits)) return std::nullopt;
  const std::optional<double> size = parse_whole_text<double>(digits);
  if (!size || !std::isfinite(*size)) return std::nullopt;
  return text[0] == '-' ? -*size : *size;
}

std::optional<std::int64_t> parse_count(std::string_view text) {
  if (!starts_like_a_number(text)) return std::nullopt;
  return parse_whole_text<std::int64_t>(text);
}

}  // namespace scanbed::scenarios
