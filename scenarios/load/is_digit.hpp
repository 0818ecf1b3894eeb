// SPDX-License-Identifier: MIT
#pragma once

namespace scanbed::scenarios {

/// Of any locale, unlike std::isdigit.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace scanbed::scenarios
