// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <map>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// Appends a blank and the shortest digits that read back to the same number; "inf", "-inf" and "nan" too.
template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append_field(std::string& out, Number value) {
  std::array<char, 32> digits;
  out.push_back(' ');
  out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

inline void append_field(std::string& out, std::string_view word) {
  out.append(" ").append(word);
}

/// Appends a blank and the number with so many digits behind the point, as printf's "%.3f".
void append_fixed(std::string& out, double value, int num_digits);

/// Metadata on one line, as JSON.
std::string metadata_text(const std::map<std::string, std::string>& metadata);

}  // namespace scanbed::hw
