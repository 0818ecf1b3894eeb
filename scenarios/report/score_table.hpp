// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scenarios/run/run_scenario.hpp"

namespace scanbed::scenarios {

/// A run's scores for people: precision and recall of each kind of feature, recall by range, gates and the
/// verdict. Plain text without colours, ends in a newline.
std::string score_table(const RunResult& result);

}  // namespace scanbed::scenarios
