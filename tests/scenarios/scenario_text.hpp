// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scenarios/load/load_scenario.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::testing {

/// The keys that every scenario must have: three lines, so that what follows begins on line 4.
inline const std::string kHead = "schema: 1\nname: test\nduration: 2\n";

inline scenarios::Scenario parse(const std::string& rest) {
  return scenarios::parse_scenario(kHead + rest, "f");
}

inline std::string parse_error(const std::string& rest) {
  return error_of([&] { parse(rest); });
}

}  // namespace scanbed::testing
