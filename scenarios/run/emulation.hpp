// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "hw/sick/emulator_options.hpp"
#include "hw/sick/scan_feed.hpp"
#include "scenarios/load/scenario.hpp"
#include "sim/engine/make_engine.hpp"

namespace scanbed::scenarios {

/// An emulated LMS that comes up as the scenario's sensor is set: its variant and its unit.
hw::EmulatorOptions emulator_options(const Scenario& scenario);

/// How the emulated LMS begins otherwise, in one line; empty where one could be set as the scenario's sensor
/// is.
std::optional<std::string> unlike_an_lms(const Scenario& scenario);

/// The scenario's scans as whatever the emulator's host configures. With the scenario's own settings they are
/// those of its simulated laser, bit for bit.
hw::ScanSupply scenario_scans(const Scenario& scenario, sim::Backend backend);

}  // namespace scanbed::scenarios
