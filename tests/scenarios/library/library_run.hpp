// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
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

/// Walkers in a crowd may touch; nothing else may.
inline bool is_of_walkers(const sim::Collision& collision, const sim::World& world) {
  const auto is_walker = [&](const std::string& id) {
    return std::any_of(world.walkers.begin(), world.walkers.end(),
                       [&](const sim::Walker& walker) { return walker.id == id; });
  };
  return is_walker(collision.first) && is_walker(collision.second);
}

/// Runs a scenario of the library with its own seed and expects each preset to meet its bars.
inline void expect_gates_met(const std::string& name, sim::Backend backend) {
  const scenarios::Scenario scenario = scenarios::load_scenario(scenarios::find_scenario(name));
  for (const std::string& preset : preset_names()) {
    sim::SimulatedLms sensor(scenario.world, {.lms = scenario.lms,
                                              .duration_s = scenario.duration_s,
                                              .seed = scenario.seed,
                                              .backend = backend,
                                              .detector = *preset_options(preset)});
    FeatureDetector detector(*preset_options(preset));
    const scenarios::RunResult result = scenarios::run_scenario(
        scenario, sensor, {detector, {}, preset}, [](const LaserScan&, const Features&) { return true; });
    EXPECT_TRUE(result.is_accepted()) << scenarios::score_table(result);
    EXPECT_FALSE(result.passed_unexpectedly()) << scenarios::score_table(result);
    for (const sim::Collision& collision : sensor.collisions()) {
      EXPECT_TRUE(is_of_walkers(collision, scenario.world)) << to_string(collision);
    }
    EXPECT_GT(result.gates.size(), 1u) << "asks for nothing of preset " << preset;
  }
}

/// The parameter as a test's name.
inline std::string name_of(const ::testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace scanbed::testing
