// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace scanbed {

/// A number as messages show it, with up to 15 digits: 5000000 and 0.1 as they were written, not 5e+06 or
/// 0.100000.
inline std::string number_text(double value) {
  constexpr int kNumDigits = 15;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kNumDigits);
  return {text.data(), end.ptr};
}

}  // namespace scanbed
