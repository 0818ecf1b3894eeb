// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "scenarios/run/run_scenario.hpp"

namespace scanbed::scenarios {

/// A table of several runs: a row for each scenario, its counts pooled over the runs that stand one behind
/// the other; then each gate that some of them missed, with the worst, and who ran into whom; then the
/// verdict. Runs that were interrupted are left out of all that.
///
/// @param num_runs  that there would be without an interrupt; where fewer are complete, the last line says
/// so.
std::string run_summary(std::span<const RunResult> results, int num_runs);

}  // namespace scanbed::scenarios
