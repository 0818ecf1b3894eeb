// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace scanbed::scenarios {

/// A decimal number, written plainly: optional sign, digits without leading zeros, fraction, exponent.
/// Empty for anything else: "012" (octal or not?), "0x10", ".5.", "nan", "inf", "1e999", "1 m", "".
std::optional<double> parse_number(std::string_view text);

/// A whole number of [0, 2^63), digits only.
std::optional<std::int64_t> parse_count(std::string_view text);

}  // namespace scanbed::scenarios
