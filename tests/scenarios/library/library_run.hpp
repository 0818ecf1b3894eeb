// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/detect/presets.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "scenarios/report/score_table.hpp"
#include "scenarios/run/run_scenario.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::testing {

inline std::vector<std::string> all_scenarios() {
  return scenarios::library_names(scenarios::library_folder());
}

/// Runs a scenario of the library with its own seed and expects each preset to meet its bars.
inline void expect_gates_met(const std::string& name, sim::Backend backend) {
  const scenarios::Scenario scenario = scenarios::load_scenario(scenarios::find_scenario(name));
  for (const std::string& preset : preset_names()) {
    sim::SimulatedLms sensor(
        scenario.world,
        {.lms = scenario.lms, .duration_s = scenario.duration_s, .seed = scenario.seed, .backend = backend});
    FeatureDetector detector(*preset_options(preset));
    const scenarios::RunResult result = scenarios::run_scenario(
        scenario, sensor, {detector, false, preset}, [](const LaserScan&, const Features&) { return true; });
    EXPECT_TRUE(result.is_accepted()) << scenarios::score_table(result);
    EXPECT_FALSE(result.passed_unexpectedly()) << scenarios::score_table(result);
    EXPECT_GT(result.gates.size(), 1u) << "asks for nothing of preset " << preset;
  }
}

/// The parameter as a test's name.
inline std::string name_of(const ::testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace scanbed::testing
