// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

namespace scanbed::scenarios {

/// A share as tables show it: "0.984", or "-" of nothing.
inline std::string share_text(int part, int whole) {
  return whole == 0 ? "-" : fmt::format("{:.3f}", static_cast<double>(part) / whole);
}

}  // namespace scanbed::scenarios
