// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/detect/feature_detector.hpp"
#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/recorder.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/command/source_watch.hpp"
#include "scenarios/report/feature_line.hpp"
#include "scenarios/run/analyst.hpp"
#include "scenarios/run/live_sensor.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {
namespace {

/// Where features go.
struct Sinks {
  Output& output;
  Recorder& recorder;
};

void print_features(const DetectCommand& command, RangeSensor& sensor, Analyst& analyst, const Sinks& sinks) {
  Progress progress("detect");
  SourceWatch watch(command.laser);
  LaserScan scan;
  std::string line;
  for (std::int64_t num_scans = 0; !command.limit || num_scans < *command.limit; ++num_scans) {
    if (is_interrupted() || !sensor.next(scan, RangeSensor::kPatience)) return;
    watch.see(scan);
    line.clear();
    const Findings findings = analyst.analyse(scan);
    sinks.recorder.see(scan, findings.features, sensor);
    append_feature_line(line, findings);
    if (!sinks.output.write(line)) return;
    progress.show(num_scans + 1);
  }
}

struct OpenedLaser {
  std::unique_ptr<RangeSensor> sensor;
  const hw::ScanReader* log = nullptr;  // where the sensor is one
  std::optional<Scenario> scenario;     // where the sensor is simulated
};

// What is no option of the detector was meant for a scenario, or is an option that is misspelt.
void refuse_scenario_settings(std::span<const Setting> settings, std::string_view laser) {
  if (settings.empty()) return;
  const std::string& path = settings[0].path;
  throw InputError(
      fmt::format("--set {}: no option of the detector, and {} has no scenario{}; see 'scanbed "
                  "options'",
                  path, laser, near_detector_setting_hint(path)));
}

OpenedLaser open_laser(const DetectCommand& command, std::span<const Setting> settings,
                       const FeatureDetector& detector) {
  const LaserSpec& spec = command.laser;
  if (command.backend != sim::Backend::kPlanar) need_simulated(spec, "--backend: engines are");
  if (spec.kind == LaserKind::kLog) {
    refuse_scenario_settings(settings, "a recording");
    auto log = open_log(spec);
    const hw::ScanReader* counts = log.get();
    return {std::move(log), counts, std::nullopt};
  }
  if (spec.is_device()) {
    refuse_scenario_settings(settings, "a device");
    return {std::make_unique<LiveSensor>(open_device(spec),
                                         LiveOptions{.is_interrupted = is_interrupted, .warn = log_warning}),
            nullptr, std::nullopt};
  }
  if (spec.target.empty()) throw InputError("--laser sim: no scenario; write sim:SCENARIO, or log:FILE");
  Scenario scenario = open_scenario(spec.target, settings, std::nullopt);
  auto sensor = simulate(scenario, command.backend, detector.options());
  return {std::move(sensor), nullptr, std::move(scenario)};
}

struct DetectTexts {
  std::string laser;
  std::string limit;
  bool track = false;
  bool interpret = false;
  std::string out;
  RecordFlag record;
  BackendFlag backend;
  DetectorFlags detector;
  SettingFlag settings;
};

DetectCommand to_detect(const DetectTexts& texts) {
  std::optional<std::int64_t> limit;
  if (!texts.limit.empty()) limit = to_count("--limit", texts.limit, 1);
  LaserSpec laser = parse_laser_spec(texts.laser);
  check_files(std::array{FlagFile{"--out", to_path(texts.out)}, texts.record.file()},
              std::array{laser_file(laser), texts.detector.file()});
  return {.laser = std::move(laser),
          .detector = texts.detector.value(),
          .settings = texts.settings.values(),
          .limit = limit,
          .track = texts.track,
          .interpret = texts.interpret,
          .out = to_path(texts.out),
          .record = texts.record.file().path,
          .backend = texts.backend.value()};
}

}  // namespace

ExitCode execute(const DetectCommand& command) {
  const SortedSettings settings = sort_settings(command.settings);
  const AnalysisOptions options = open_detector(command.detector, settings.detector,
                                                {.tracks = command.track, .interprets = command.interpret});
  FeatureDetector detector(options.detector);
  Analyst analyst(detector, {.track = command.track,
                             .interpret = command.interpret,
                             .tracker = options.track,
                             .interpreter = options.interpret});
  const OpenedLaser laser = open_laser(command, settings.scenario, detector);
  Output output(command.out, Output::Unfinished::kKept);
  hw::RecordingMetadata metadata = recording_metadata(command.laser.text, preset_of(options));
  if (laser.scenario) add_scenario(metadata, command.laser.target, laser.scenario->seed);
  Recorder recorder(command.record, metadata);
  // Whatever ends it, what was made until then is kept: also by one output where the other's disk is full.
  std::exception_ptr fault;
  const auto attempt = [&](const auto& step) {
    try {
      step();
    } catch (const std::exception&) {
      if (!fault) fault = std::current_exception();
    }
  };
  attempt([&] { print_features(command, *laser.sensor, analyst, {output, recorder}); });
  attempt([&] { output.commit(); });
  attempt([&] { recorder.finish(); });
  if (laser.log != nullptr) log_note(to_text(laser.log->counts()));
  if (fault) std::rethrow_exception(fault);
  return is_interrupted() ? kExitInterrupted : kExitFine;
}

Usage detect_usage() {
  auto texts = std::make_shared<DetectTexts>();
  Usage usage{.name = "detect", .summary = "Print the features of each scan as JSON Lines"};
  usage.flags = {
      {"--laser", "SPEC",
       "log:FILE, sim:SCENARIO, sick:PORT, scip:PORT or cola:HOST, with options behind '?'; see below",
       &texts->laser, true},
      {"--limit", "N", "Stop after N scans", &texts->limit},
      {"--track", "", "Follow people, legs and cylinders: adds \"tracks\"", &texts->track},
      {"--interpret", "", "Name walls, corners, columns, benches, doors and trash cans: adds \"scene\"",
       &texts->interpret},
      {"--out", "FILE", "In place of standard output", &texts->out},
      texts->record.flag(),
      texts->backend.flag(),
      texts->detector.preset_flag(),
      texts->detector.config_flag(),
      texts->settings.flag(),
  };
  usage.footer = R"(Prints one JSON object a scan, in metres and radians of the sensor's frame.
Lasers, and options as in 'log:FILE?from=2&to=10':
  log:FILE      only=NAME no_return=METRES speed=X from=S to=S
  sim:SCENARIO
  sick:PORT     baud=38400 fov_deg=180 resolution_deg=0.5 unit=mm mode=0 lossless=0 (1: for emulators)
  scip:PORT     baud=115200; or scip:HOST, scip:HOST:10940
  cola:HOST     or cola:HOST:2111
Examples:
  scanbed detect --laser log:hall.log.gz --limit 10
  scanbed detect --laser 'log:hall.log?only=FLASER&no_return=81.83' --set surface.arc_price=24
  scanbed detect --laser sim:static_hallway --out features.jsonl
  scanbed detect --laser log:walk.bag --track --interpret
  scanbed detect --laser 'log:walk.bag?speed=1&from=2&to=10' --record walk.mcap
)" + table_two_text();
  usage.command = [texts] { return to_detect(*texts); };
  return usage;
}

}  // namespace scanbed::scenarios
