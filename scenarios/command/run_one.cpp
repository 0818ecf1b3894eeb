// SPDX-License-Identifier: MIT
#include "scenarios/command/run_one.hpp"

#include <cmath>
#include <memory>
#include <optional>

#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/recorder.hpp"
#include "scenarios/run/live_sensor.hpp"
#include "scenarios/run/picture_taker.hpp"

namespace scanbed::scenarios {
namespace {

Recorder open_recorder(const RunCommand& command, const Scenario& scenario) {
  hw::RecordingMetadata metadata = recording_metadata(command.laser.text, command.detector.preset);
  if (command.record) add_scenario(metadata, command.scenarios.front(), scenario.seed);
  return {command.record, metadata};
}

RunAndPictures run_simulated(const RunCommand& command, const Run& run) {
  const Scenario& scenario = run.scenario;
  const std::unique_ptr<sim::SimulatedLms> sensor =
      simulate(scenario, command.backend, run.processing.detector.options());
  std::optional<PictureTaker> pictures;
  if (run.out) pictures.emplace(scenario, *sensor, *run.out);
  Recorder recorder = open_recorder(command, scenario);
  std::optional<Progress> progress;
  if (run.shows_progress) progress.emplace(scenario.name);
  RunAndPictures done;
  done.result =
      run_scenario(scenario, *sensor, run.processing, [&](const LaserScan& scan, const Features& features) {
        if (pictures) pictures->see(scan, features);
        recorder.see(scan, features, *sensor);
        if (progress) progress->show(scan.index + 1);
        return !is_interrupted();
      });
  recorder.finish();
  if (pictures) done.pictures = pictures->files();
  return done;
}

RunAndPictures run_on_log(const RunCommand& command, const Run& run) {
  const Scenario& scenario = run.scenario;
  const std::unique_ptr<hw::ScanReader> log = open_log(command.laser);
  Recorder recorder = open_recorder(command, scenario);
  std::optional<Progress> progress;
  if (run.shows_progress) progress.emplace(scenario.name);
  RunAndPictures done;
  done.result =
      run_scenario(scenario, *log, run.processing, [&](const LaserScan& scan, const Features& features) {
        recorder.see(scan, features, *log);
        if (progress) progress->show(scan.index + 1);
        return !is_interrupted();
      });
  recorder.finish();
  log_note(to_text(log->counts()));
  return done;
}

// As many scans of a device as the scenario's simulated laser would give.
RunAndPictures run_on_device(const RunCommand& command, const Run& run) {
  const Scenario& scenario = run.scenario;
  const double num_scans = std::ceil(scenario.duration_s / scenario.lms.scan_period_s - 1e-9);
  LiveSensor sensor(open_device(command.laser), {.limit = static_cast<std::int64_t>(num_scans),
                                                 .is_interrupted = is_interrupted,
                                                 .truth = command.truth,
                                                 .warn = log_warning});
  Recorder recorder = open_recorder(command, scenario);
  std::optional<Progress> progress;
  if (run.shows_progress) progress.emplace(scenario.name);
  RunAndPictures done;
  done.result =
      run_scenario(scenario, sensor, run.processing, [&](const LaserScan& scan, const Features& features) {
        recorder.see(scan, features, sensor);
        if (progress) progress->show(scan.index + 1);
        return !is_interrupted();
      });
  recorder.finish();
  return done;
}

RunAndPictures run_on_laser(const RunCommand& command, const Run& run) {
  if (command.laser.is_device()) return run_on_device(command, run);
  if (command.laser.kind == LaserKind::kLog) return run_on_log(command, run);
  return run_simulated(command, run);
}

}  // namespace

RunAndPictures run_one(const RunCommand& command, const Run& run) {
  RunAndPictures done = run_on_laser(command, run);
  done.result.laser = command.laser.text;
  return done;
}

}  // namespace scanbed::scenarios
