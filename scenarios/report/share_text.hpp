// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

namespace scanbed::scenarios {

/// A share as tables show it: "0.984", or "-" of nothing.
inline std::string share_text(int part, int whole) {
  return whole == 0 ? "-" : fmt::format("{:.3f}", static_cast<double>(part) / whole);
}

/// A value with so many decimals, or "-" of nothing.
inline std::string value_text(const std::optional<double>& value, int num_decimals) {
  return value ? fmt::format("{:.{}f}", *value, num_decimals) : "-";
}

}  // namespace scanbed::scenarios
