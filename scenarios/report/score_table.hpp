// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "scenarios/run/run_scenario.hpp"

namespace scanbed::scenarios {

/// What is said of a run whose laser has no truth.
inline constexpr std::string_view kNotScored =
    "not scored: this laser brings no truth, so no gate was measured";

/// A run's scores for people: precision and recall of each kind of feature, recall by range, gates and the
/// verdict. Plain text without colours, ends in a newline.
std::string score_table(const RunResult& result);

}  // namespace scanbed::scenarios
