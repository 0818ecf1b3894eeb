// SPDX-License-Identifier: MIT
#include "scenarios/command/run_one.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "core/errors/input_error.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/recorder.hpp"
#include "scenarios/command/source_watch.hpp"
#include "scenarios/run/live_sensor.hpp"
#include "scenarios/run/picture_taker.hpp"

namespace scanbed::scenarios {
namespace {

Recorder open_recorder(const RunCommand& command, const Run& run) {
  hw::RecordingMetadata metadata = recording_metadata(command.laser.text, run.processing.preset);
  if (command.record) add_scenario(metadata, run.name, run.scenario.seed);
  return {command.record, metadata};
}

// Tells `see` of each scan that was judged, if there is such.
RunResult run_on(RangeSensor& sensor, const RunCommand& command, const Run& run,
                 const std::function<void(const LaserScan&, const Features&)>& see = {}) {
  Recorder recorder = open_recorder(command, run);
  std::optional<Progress> progress;
  if (run.shows_progress) progress.emplace(run.scenario.name);
  RunResult result = run_scenario(run.scenario, sensor, run.processing,
                                  [&](const LaserScan& scan, const Features& features) {
                                    if (see) see(scan, features);
                                    recorder.see(scan, features, sensor);
                                    if (progress) progress->show(scan.index + 1);
                                    return !is_interrupted();
                                  });
  recorder.finish();
  return result;
}

RunAndPictures run_simulated(const RunCommand& command, const Run& run) {
  const std::unique_ptr<sim::SimulatedLms> sensor =
      simulate(run.scenario, command.backend, run.processing.detector.options());
  std::optional<PictureTaker> pictures;
  if (run.out) pictures.emplace(run.scenario, *sensor, *run.out);
  RunAndPictures done;
  done.result = run_on(*sensor, command, run, [&](const LaserScan& scan, const Features& features) {
    if (pictures) pictures->see(scan, features);
  });
  done.result.seed = run.scenario.seed;
  done.result.engine = to_string(command.backend);
  done.result.collisions = sensor->collisions();
  if (pictures) done.pictures = pictures->files();
  return done;
}

// The scenario's bars and names are held against whatever the scans show.
void warn_of_another_world(const hw::ScanReader& log, const RunCommand& command, const Run& run) {
  const auto recorded = log.metadata().find("scenario");
  if (recorded == log.metadata().end()) return;
  const auto stem_of = [](const std::filesystem::path& name_or_path) { return name_or_path.stem(); };
  if (stem_of(recorded->second) == stem_of(run.name)) return;
  log_warning(fmt::format("{}: was recorded in the scenario {}, not in {}", command.laser.target,
                          quote(recorded->second), quote(run.name)));
}

RunAndPictures run_on_log(const RunCommand& command, const Run& run) {
  const std::unique_ptr<hw::ScanReader> log = open_log(command.laser);
  warn_of_another_world(*log, command, run);
  SourceWatch watch(command.laser);
  RunAndPictures done;
  done.result = run_on(*log, command, run, [&](const LaserScan& scan, const Features&) { watch.see(scan); });
  log_note(to_text(log->counts()));
  done.result.interrupted = done.result.interrupted || is_interrupted();
  return done;
}

// As many scans of a device as the scenario's simulated laser would give.
RunAndPictures run_on_device(const RunCommand& command, const Run& run) {
  const double num_scans = std::ceil(run.scenario.duration_s / run.scenario.lms.scan_period_s - 1e-9);
  LiveSensor sensor(open_device(command.laser), {.limit = static_cast<std::int64_t>(num_scans),
                                                 .from_zero = true,
                                                 .is_interrupted = is_interrupted,
                                                 .truth = command.truth,
                                                 .warn = log_warning});
  RunAndPictures done{.result = run_on(sensor, command, run), .pictures = {}};
  if (command.truth && done.result.num_scans > 0 && sensor.num_truths() == 0) {
    throw InputError(
        fmt::format("--truth {}: is of none of the {} scans; allowed: what emulate wrote for these",
                    command.truth->string(), done.result.num_scans));
  }
  // An interrupt mostly comes while a scan is waited for, and then no observer notices it.
  done.result.interrupted = done.result.interrupted || is_interrupted();
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
