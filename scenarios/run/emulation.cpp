// SPDX-License-Identifier: MIT
#include "scenarios/run/emulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::scenarios {
namespace {

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

hw::LmsVariant variant_of(const Scenario& scenario) {
  return {rounded(degrees(scenario.lms.fov_rad)), rounded(100.0 * degrees(scenario.lms.step_rad))};
}

}  // namespace

std::optional<std::string> unlike_an_lms(const Scenario& scenario) {
  if (variant_of(scenario).is_offered()) return std::nullopt;
  const hw::LmsVariant begins = hw::EmulatorOptions{}.variant;
  return fmt::format(
      "no LMS 2xx sees {:.4g} degrees in steps of {:.4g}; the emulated one begins with {} and {}",
      degrees(scenario.lms.fov_rad), degrees(scenario.lms.step_rad), begins.fov_deg,
      begins.resolution_cdeg / 100.0);
}

hw::EmulatorOptions emulator_options(const Scenario& scenario) {
  hw::EmulatorOptions options;
  if (variant_of(scenario).is_offered()) options.variant = variant_of(scenario);
  options.configuration.set_unit(scenario.lms.unit);
  options.seed = scenario.seed;
  return options;
}

hw::ScanSupply scenario_scans(const Scenario& scenario, sim::Backend backend) {
  const auto is_near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  return [scenario, backend, is_near](const hw::LmsStreamSettings& settings) -> std::unique_ptr<RangeSensor> {
    sim::SimulationOptions options{
        .lms = scenario.lms, .duration_s = scenario.duration_s, .seed = scenario.seed, .backend = backend};
    const double fov_rad = radians(settings.variant.fov_deg);
    const double step_rad = radians(settings.variant.resolution_cdeg / 100.0);
    // What is the same stays as the scenario has it, to the last bit.
    if (!is_near(options.lms.fov_rad, fov_rad)) options.lms.fov_rad = fov_rad;
    if (!is_near(options.lms.step_rad, step_rad)) options.lms.step_rad = step_rad;
    options.lms.unit = settings.unit;
    // Finer steps take more turns; the scenario's own scans may come faster than those can.
    options.lms.scan_period_s =
        std::max(options.lms.scan_period_s, options.lms.num_rotations() * options.lms.rotation_s);
    return std::make_unique<sim::SimulatedLms>(scenario.world, options);
  };
}

}  // namespace scanbed::scenarios
