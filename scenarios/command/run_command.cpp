// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/output.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/recorder.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/report/run_json.hpp"
#include "scenarios/report/score_table.hpp"
#include "scenarios/run/live_sensor.hpp"
#include "scenarios/run/picture_taker.hpp"
#include "scenarios/run/run_scenario.hpp"

namespace scanbed::scenarios {
namespace {

struct RunAndPictures {
  RunResult result;
  std::vector<std::filesystem::path> pictures;
};

Recorder open_recorder(const RunCommand& command, const Scenario& scenario) {
  hw::RecordingMetadata metadata = recording_metadata(command.laser.text, command.detector.preset);
  if (command.record) add_scenario(metadata, command.scenarios.front(), scenario.seed);
  return {command.record, metadata};
}

RunAndPictures run_simulated(const RunCommand& command, const Scenario& scenario,
                             const Processing& processing) {
  const std::unique_ptr<sim::SimulatedLms> sensor =
      simulate(scenario, command.backend, processing.detector.options());
  std::optional<PictureTaker> pictures;
  if (command.out) pictures.emplace(scenario, *sensor, *command.out);
  Recorder recorder = open_recorder(command, scenario);
  Progress progress(scenario.name);
  RunAndPictures run;
  run.result =
      run_scenario(scenario, *sensor, processing, [&](const LaserScan& scan, const Features& features) {
        if (pictures) pictures->see(scan, features);
        recorder.see(scan, features, *sensor);
        progress.show(scan.index + 1);
        return !is_interrupted();
      });
  recorder.finish();
  if (pictures) run.pictures = pictures->files();
  return run;
}

RunAndPictures run_on_log(const RunCommand& command, const Scenario& scenario, const Processing& processing) {
  const std::unique_ptr<hw::ScanReader> log = open_log(command.laser);
  Recorder recorder = open_recorder(command, scenario);
  Progress progress(scenario.name);
  RunAndPictures run;
  run.result = run_scenario(scenario, *log, processing, [&](const LaserScan& scan, const Features& features) {
    recorder.see(scan, features, *log);
    progress.show(scan.index + 1);
    return !is_interrupted();
  });
  recorder.finish();
  log_note(to_text(log->counts()));
  return run;
}

// As many scans of a device as the scenario's simulated laser would give.
RunAndPictures run_on_device(const RunCommand& command, const Scenario& scenario,
                             const Processing& processing) {
  const double num_scans = std::ceil(scenario.duration_s / scenario.lms.scan_period_s - 1e-9);
  LiveSensor sensor(open_device(command.laser), {.limit = static_cast<std::int64_t>(num_scans),
                                                 .is_interrupted = is_interrupted,
                                                 .truth = command.truth,
                                                 .warn = log_warning});
  Recorder recorder = open_recorder(command, scenario);
  Progress progress(scenario.name);
  RunAndPictures run;
  run.result =
      run_scenario(scenario, sensor, processing, [&](const LaserScan& scan, const Features& features) {
        recorder.see(scan, features, sensor);
        progress.show(scan.index + 1);
        return !is_interrupted();
      });
  recorder.finish();
  return run;
}

RunAndPictures run_one(const RunCommand& command, const Scenario& scenario, const Processing& processing) {
  if (command.laser.is_device()) return run_on_device(command, scenario, processing);
  if (command.laser.kind == LaserKind::kLog) return run_on_log(command, scenario, processing);
  return run_simulated(command, scenario, processing);
}

void check(const RunCommand& command) {
  if (command.truth && !command.laser.is_device()) {
    throw InputError("--truth: only for scans of a device; write --laser sick:PORT");
  }
  if (!command.laser.target.empty() && command.laser.kind == LaserKind::kSimulated) {
    throw InputError("--laser " + command.laser.text + ": run takes its scenarios as arguments; write sim");
  }
  if (command.record && command.scenarios.size() > 1) {
    throw InputError("--record: one recording holds one scenario; found " +
                     std::to_string(command.scenarios.size()));
  }
  if (!command.out) return;
  std::error_code error;
  std::filesystem::create_directories(*command.out, error);
  if (error) throw OutputFault(fmt::format("{}: {}", command.out->string(), error.message()));
}

std::string describe(const RunAndPictures& run) {
  std::string text = score_table(run.result);
  for (const std::filesystem::path& file : run.pictures) text += "picture: " + file.string() + "\n";
  return text;
}

ExitCode exit_code(const std::vector<RunResult>& results) {
  if (is_interrupted()) return kExitInterrupted;
  for (const RunResult& result : results) {
    if (!result.is_accepted()) return kExitGateMissed;
  }
  return kExitFine;
}

struct RunTexts {
  std::vector<std::string> scenarios;
  std::string laser = "sim";
  std::string truth;
  SeedFlag seed;
  std::string json;
  std::string out;
  bool is_quiet = false;
  bool track = false;
  RecordFlag record;
  BackendFlag backend;
  DetectorFlags detector;
  SettingFlag settings;
};

RunCommand to_run(const RunTexts& texts) {
  return {.scenarios = texts.scenarios,
          .laser = parse_laser_spec(texts.laser),
          .seed = texts.seed.value(),
          .detector = texts.detector.value(),
          .settings = texts.settings.values(),
          .json = to_path(texts.json),
          .out = to_path(texts.out),
          .record = to_path(texts.record.text),
          .truth = to_path(texts.truth),
          .quiet = texts.is_quiet,
          .track = texts.track,
          .backend = texts.backend.value()};
}

}  // namespace

ExitCode execute(const RunCommand& command) {
  check(command);
  const SortedSettings settings = sort_settings(command.settings);
  const AnalysisOptions options = open_detector(command.detector, settings.detector);
  FeatureDetector detector(options.detector);
  // All are loaded before the first one runs: a misspelt name shows at once.
  std::vector<Scenario> scenarios;
  for (const std::string& name : command.scenarios) {
    scenarios.push_back(open_scenario(name, settings.scenario, command.seed));
  }
  std::vector<RunResult> results;
  const bool prints_table = !command.quiet && command.json != "-";
  for (const Scenario& scenario : scenarios) {
    if (is_interrupted()) break;
    RunAndPictures run =
        run_one(command, scenario, {detector, command.track, command.detector.preset, options.track});
    run.result.laser = command.laser.text;
    if (run.result.passed_unexpectedly()) {
      log_warning(scenario.name + ": passed, although known to fail: " + *scenario.known_fail);
    }
    if (prints_table) write_whole(std::nullopt, (results.empty() ? "" : "\n") + describe(run));
    results.push_back(std::move(run.result));
  }
  if (command.json) write_whole(command.json, run_json(results));
  return exit_code(results);
}

Usage run_usage() {
  auto texts = std::make_shared<RunTexts>();
  Usage usage{.name = "run", .summary = "Run scenarios, score the detectors, hold scores against gates"};
  usage.flags = {
      {"SCENARIO", "", "Names of the library or YAML files", &texts->scenarios, true},
      {"--laser", "SPEC", "sim, log:FILE, sick:PORT, scip:PORT or cola:HOST", &texts->laser},
      {"--truth", "FILE", "Truth of a device's scans, as emulate writes it", &texts->truth},
      texts->seed.flag(),
      {"--json", "FILE", "Write results as JSON; - is standard output", &texts->json},
      {"--out", "DIR", "Write the scenario's pictures here", &texts->out},
      {"--track", "", "Follow people and cylinders, and score that too", &texts->track},
      {"--quiet", "", "No table", &texts->is_quiet},
      texts->record.flag(),
      texts->backend.flag(),
      texts->detector.preset_flag(),
      texts->detector.config_flag(),
      texts->settings.flag(),
  };
  usage.footer = R"(Examples:
  scanbed run static_hallway
  scanbed run static_hallway --seed 7 --set sensor.noise.sigma=0.012 --json -
  scanbed run my_hall.yaml --preset paper --set line_err=0.02 --out pictures
)" + table_two_text();
  usage.command = [texts] { return to_run(*texts); };
  return usage;
}

}  // namespace scanbed::scenarios
