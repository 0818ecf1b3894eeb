// SPDX-License-Identifier: MIT
#include "scenarios/run/emulation.hpp"

#include <cmath>
#include <memory>

#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::scenarios {
namespace {

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

hw::EmulatorOptions emulator_options(const Scenario& scenario) {
  hw::EmulatorOptions options;
  const hw::LmsVariant variant{rounded(degrees(scenario.lms.fov_rad)),
                               rounded(100.0 * degrees(scenario.lms.step_rad))};
  if (variant.is_offered()) options.variant = variant;
  options.configuration.set_unit(scenario.lms.unit);
  options.seed = scenario.seed;
  return options;
}

hw::ScanSource scenario_scans(const Scenario& scenario, sim::Backend backend) {
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
    return std::make_unique<sim::SimulatedLms>(scenario.world, options);
  };
}

}  // namespace scanbed::scenarios
