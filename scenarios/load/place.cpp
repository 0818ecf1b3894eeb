// SPDX-License-Identifier: MIT
#include "scenarios/load/place.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/errors/input_error.hpp"

namespace scanbed::scenarios {
namespace {

constexpr std::size_t kLongestQuote = 40;

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

std::string to_string(const Place& place) {
  const std::string source = place.source ? place.source->name : std::string("input");
  return place.line == 0 ? source : fmt::format("{}:{}:{}", source, place.line, place.column);
}

void refuse(const Place& place, std::string_view message) {
  std::string line = fmt::format("{}: {}", to_string(place), message);
  // Messages repeat what stands in the file: ids, and words that the YAML library quotes.
  std::replace_if(line.begin(), line.end(), is_control, '?');
  throw InputError(line);
}

std::string quote(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, kLongestQuote)) result += is_control(c) ? '?' : c;
  if (text.size() > kLongestQuote) result += "...";
  return result + "'";
}

}  // namespace scanbed::scenarios
