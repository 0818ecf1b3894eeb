// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace scanbed::scenarios {

/// Of the program, as the build states it: "0.1.0".
inline constexpr std::string_view kVersion = SCANBED_VERSION;

}  // namespace scanbed::scenarios
