// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/detect/feature_detector.hpp"
#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/output.hpp"
#include "scenarios/run/picture_taker.hpp"

namespace scanbed::scenarios {
namespace {

constexpr RangeSensor::Seconds kNoWait{0.0};

// Runs the scenario up to the scan that shows the moment.
LaserScan scan_at(const Scenario& scenario, sim::SimulatedLms& sensor, double at_s) {
  LaserScan scan;
  do {
    if (!sensor.next(scan, kNoWait)) {
      throw SensorFault(SensorFault::Kind::kSimulator, fmt::format("no scan at {} s", at_s));
    }
  } while (!is_interrupted() && !shows(scenario, scan, at_s));
  return scan;
}

void check_folder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw OutputFault(fmt::format("{}: cannot be written: no folder {}", file.string(), folder.string()));
  }
}

}  // namespace

ExitCode execute(const RenderCommand& command) {
  const SortedSettings settings = sort_settings(command.settings);
  FeatureDetector detector(detector_options(command.detector, settings.detector));
  const Scenario scenario = open_scenario(command.scenario, settings.scenario, command.seed);
  require(command.at_s >= 0.0 && command.at_s <= scenario.duration_s, "--at", command.at_s,
          fmt::format("[0, {}], the scenario's duration", scenario.duration_s));
  check_folder(command.out);
  const std::unique_ptr<sim::SimulatedLms> sensor = simulate(scenario);
  const LaserScan scan = scan_at(scenario, *sensor, command.at_s);
  if (is_interrupted()) return kExitInterrupted;
  const Features& features = detector.detect(scan);
  sim::ScenePainter painter(sensor->world(), command.picture);
  const sim::Image image = painter.paint(sensor->state(), scan, features, caption(scenario, scan));
  sim::write_png(image, command.out);
  write_whole(std::nullopt, "picture: " + command.out.string() + "\n");
  return kExitFine;
}

}  // namespace scanbed::scenarios
