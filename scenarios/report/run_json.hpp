// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "scenarios/run/run_scenario.hpp"

namespace scanbed::scenarios {

/// All runs as one JSON document: `--json`. The same results give the same bytes: there is no time of day in
/// it, keys have a fixed order, numbers are rounded to 1e-9. What was not measured is null.
std::string run_json(std::span<const RunResult> results);

}  // namespace scanbed::scenarios
