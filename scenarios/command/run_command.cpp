// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string_view>
#include <system_error>

#include "core/errors/input_error.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/run_one.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/place.hpp"
#include "scenarios/report/run_json.hpp"
#include "scenarios/report/run_summary.hpp"
#include "scenarios/report/score_table.hpp"
#include "scenarios/run/in_order.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {
namespace {

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw OutputFault(fmt::format("{}: {}", path.string(), error.message()));
}

// One scenario with one seed. The first seed of each is loaded before anything runs, so that a misspelt name
// shows at once; the others by who runs them.
struct Task {
  std::string name;
  std::optional<std::uint64_t> seed;
  std::optional<Scenario> scenario;
  std::optional<std::filesystem::path> out;  // folder for its pictures
};

void add_tasks(const RunCommand& command, const std::string& name, std::span<const Setting> settings,
               std::vector<Task>& tasks) {
  const int num_seeds = command.seeds ? command.seeds->count() : 1;
  for (int i = 0; i < num_seeds; ++i) {
    Task task{.name = name, .seed = {}, .scenario = {}, .out = command.out};
    if (command.seeds) task.seed = command.seeds->first + static_cast<std::uint64_t>(i);
    if (i == 0) task.scenario = open_scenario(name, settings, task.seed);
    if (command.out && num_seeds > 1) task.out = *command.out / fmt::format("seed_{}", *task.seed);
    tasks.push_back(std::move(task));
  }
}

std::vector<Task> tasks_of(const RunCommand& command, std::span<const Setting> settings) {
  std::vector<Task> tasks;
  // A run that is done twice is no further evidence; patterns overlap.
  std::set<std::filesystem::path> files;
  for (const std::string& pattern : command.scenarios) {
    for (const std::string& name : names_that_fit(pattern)) {
      std::error_code error;
      const bool is_new = files.insert(std::filesystem::weakly_canonical(find_scenario(name), error)).second;
      if (is_new) add_tasks(command, name, settings, tasks);
    }
  }
  return tasks;
}

// The first seed's world was fine: without this one the message is a riddle.
Scenario open_with_seed(const Task& task, std::span<const Setting> settings) {
  try {
    return open_scenario(task.name, settings, task.seed);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} (seed {})", error.what(), *task.seed));
  }
}

bool is_one_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return a == b || std::filesystem::equivalent(find_scenario(a), find_scenario(b), error);
}

// Results and pictures are told apart by the names of their scenarios.
void check_names(const std::vector<Task>& tasks) {
  std::map<std::string, std::string> file_of_name;
  for (const Task& task : tasks) {
    if (!task.scenario) continue;
    const auto [first, is_new] = file_of_name.emplace(task.scenario->name, task.name);
    if (is_new || is_one_file(first->second, task.name)) continue;
    throw InputError(fmt::format("{}: name: {} is that of {} too; allowed: a name of its own", task.name,
                                 quote(first->first), first->second));
  }
}

void check_laser(const RunCommand& command) {
  if (command.truth && !command.laser.is_device()) {
    throw InputError("--truth: only for scans of a device; write --laser sick:PORT");
  }
  if (command.laser.kind == LaserKind::kSimulated) {
    if (command.laser.target.empty()) return;
    throw InputError("--laser " + command.laser.text + ": run takes its scenarios as arguments; write sim");
  }
  if (command.out) need_simulated(command.laser, "--out: pictures are");
  if (command.seeds) need_simulated(command.laser, "--seed: seeds are");
  if (command.backend != sim::Backend::kPlanar) need_simulated(command.laser, "--backend: engines are");
}

// What a recording shows has been; a scenario says what it is held to, no more.
void check_settings(const RunCommand& command, std::span<const Setting> settings) {
  if (command.laser.kind != LaserKind::kLog) return;
  constexpr std::array<std::string_view, 6> kOfTheWorld = {"sensor", "world",    "actors",
                                                           "robot",  "generate", "seed"};
  for (const Setting& setting : settings) {
    const std::string_view section = std::string_view(setting.path).substr(0, setting.path.find('.'));
    if (std::find(kOfTheWorld.begin(), kOfTheWorld.end(), section) == kOfTheWorld.end()) continue;
    need_simulated(command.laser, fmt::format("--set {}: worlds are", setting.path));
  }
}

bool has_pictures(const Task& task) {
  if (!task.scenario) return false;
  const PictureTimes& times = task.scenario->pictures;
  return !times.top_s.empty() || !times.camera_s.empty() || !times.laser_s.empty();
}

void check_tasks(const RunCommand& command, const std::vector<Task>& tasks) {
  if (command.out && std::none_of(tasks.begin(), tasks.end(), has_pictures)) {
    throw InputError(
        "--out: no scenario asks for pictures; write outputs: {pictures: {top: [0]}} in its file");
  }
  if (command.record && tasks.size() > 1) {
    throw InputError(fmt::format("--record: one recording holds one run; found {}", tasks.size()));
  }
  if (command.laser.kind != LaserKind::kSimulated && tasks.size() > 1) {
    throw InputError(
        fmt::format("--laser {}: its scans show one run; found {}", command.laser.text, tasks.size()));
  }
  check_names(tasks);
  for (const Task& task : tasks) {
    if (task.out) make_folder(*task.out);
  }
}

std::string describe(const RunAndPictures& run) {
  std::string text = score_table(run.result);
  for (const std::filesystem::path& file : run.pictures) text += "picture: " + file.string() + "\n";
  return text;
}

// Devices and recordings are read one after the other; pictures are painted on one thread.
int num_workers(const RunCommand& command) {
  const bool is_alone = command.laser.kind != LaserKind::kSimulated || command.out || command.record;
  return is_alone ? 1 : command.num_workers;
}

// The script drives on through what it meets: somebody should know. The summary of several runs says it too.
void warn_of_collisions(const RunResult& result) {
  if (result.collisions.empty()) return;
  const std::size_t num_more = result.collisions.size() - 1;
  log_warning(fmt::format("{}: {}{}", result.scenario, to_string(result.collisions.front()),
                          num_more == 0 ? "" : fmt::format("; {} more in --json", num_more)));
}

// Whoever waits for gates should know that there was nothing to hold against them.
void warn_of_missing_truth(const RunResult& result, const Scenario& scenario) {
  if (result.scores || result.num_scans == 0 || scenario.needs.empty()) return;
  log_warning(fmt::format("{}: {}", result.scenario, kNotScored));
}

// Tells of each run as it ends, and of all of them.
class Reporter {
 public:
  Reporter(const RunCommand& command, int num_runs)
      : command_(command), num_runs_(num_runs), progress_(fmt::format("{} runs", num_runs), "done") {
    if (command.json) json_.emplace(command.json);
  }

  void take(RunAndPictures run) {
    const RunResult& result = run.result;
    if (result.passed_unexpectedly()) {
      log_warning(result.scenario + ": passed, although known to fail: " + *result.known_fail);
    }
    if (num_runs_ == 1) warn_of_collisions(result);
    if (prints() && (num_runs_ == 1 || command_.tables)) {
      print((results_.empty() ? "" : "\n") + describe(run));
    }
    results_.push_back(std::move(run.result));
    if (num_runs_ > 1) progress_.show(static_cast<std::int64_t>(results_.size()));
  }

  bool has_any() const { return !results_.empty(); }

  ExitCode finish() {
    if (prints() && num_runs_ > 1) print((command_.tables ? "\n" : "") + run_summary(results_, num_runs_));
    if (json_) {
      json_->write(run_json(results_));
      json_->commit();
    }
    if (not_printed_) std::rethrow_exception(not_printed_);
    if (is_interrupted()) return kExitInterrupted;
    const bool is_fine = std::all_of(results_.begin(), results_.end(),
                                     [](const RunResult& result) { return result.is_accepted(); });
    return is_fine ? kExitFine : kExitGateMissed;
  }

 private:
  bool prints() const { return !command_.quiet && command_.json != "-" && !not_printed_; }

  // Where nobody reads any more what is printed, the file is written all the same.
  void print(const std::string& text) {
    try {
      write_whole(std::nullopt, text);
    } catch (const OutputFault&) {
      if (!json_) throw;
      not_printed_ = std::current_exception();
    }
  }

  const RunCommand& command_;
  std::optional<Output> json_;  // made before the runs, so that none is lost to a misspelt folder
  std::exception_ptr not_printed_;
  int num_runs_;
  std::vector<RunResult> results_;
  Progress progress_;
};

struct RunTexts {
  std::vector<std::string> scenarios;
  std::string laser = "sim";
  std::string truth;
  SeedsFlag seeds;
  JobsFlag jobs;
  bool all = false;
  bool tables = false;
  std::string json;
  std::string out;
  bool is_quiet = false;
  bool track = false;
  RecordFlag record;
  BackendFlag backend;
  DetectorFlags detector;
  SettingFlag settings;
};

// --all is a pattern that every name fits.
std::vector<std::string> scenarios_of(const RunTexts& texts) {
  if (texts.all && !texts.scenarios.empty()) {
    throw InputError("--all: goes without scenarios; found " + quote(texts.scenarios.front()));
  }
  if (texts.all) return {"*"};
  if (texts.scenarios.empty()) throw InputError("SCENARIO is required; see 'scanbed run --help'");
  return texts.scenarios;
}

RunCommand to_run(const RunTexts& texts) {
  if (texts.tables && (texts.is_quiet || texts.json == "-")) {
    throw InputError("--tables: no table is printed with --quiet or --json -; leave one of them out");
  }
  LaserSpec laser = parse_laser_spec(texts.laser);
  std::vector<FlagFile> read = scenario_files(texts.scenarios);
  read.insert(read.end(), {laser_file(laser), {"--truth", to_path(texts.truth)}, texts.detector.file()});
  check_files(std::array{FlagFile{"--json", to_path(texts.json)}, texts.record.file()}, read);
  return {.scenarios = scenarios_of(texts),
          .laser = std::move(laser),
          .seeds = texts.seeds.value(),
          .num_workers = texts.jobs.value(),
          .detector = texts.detector.value(),
          .settings = texts.settings.values(),
          .json = to_path(texts.json),
          .out = to_file("--out", texts.out),
          .record = texts.record.file().path,
          .truth = to_path(texts.truth),
          .quiet = texts.is_quiet,
          .tables = texts.tables,
          .track = texts.track,
          .backend = texts.backend.value()};
}

}  // namespace

ExitCode execute(const RunCommand& command) {
  check_laser(command);
  const SortedSettings settings = sort_settings(command.settings);
  const AnalysisOptions options =
      open_detector(command.detector, settings.detector, {.tracks = command.track, .interprets = false});
  check_settings(command, settings.scenario);
  std::vector<Task> tasks = tasks_of(command, settings.scenario);
  check_tasks(command, tasks);
  Reporter reporter(command, static_cast<int>(tasks.size()));
  std::vector<std::optional<RunAndPictures>> runs(tasks.size());
  std::exception_ptr fault;
  try {
    do_in_order({.num_jobs = static_cast<int>(tasks.size()),
                 .num_workers = num_workers(command),
                 .work =
                     [&](int i) {
                       if (is_interrupted()) return;
                       Task& task = tasks[i];
                       if (!task.scenario) task.scenario = open_with_seed(task, settings.scenario);
                       FeatureDetector detector(options.detector);
                       const AnalystOptions analysis{command.track, false, options.track, options.interpret};
                       const Processing processing{detector, analysis, preset_of(options)};
                       runs[i] = run_one(
                           command, {task.name, *task.scenario, processing, task.out, tasks.size() == 1});
                       warn_of_missing_truth(runs[i]->result, *task.scenario);
                       task.scenario.reset();
                     },
                 .finish =
                     [&](int i) {
                       if (runs[i]) reporter.take(std::move(*runs[i]));
                       return runs[i].has_value();
                     }});
  } catch (...) {
    if (!reporter.has_any()) throw;
    fault = std::current_exception();
  }
  const ExitCode code = reporter.finish();
  if (fault) std::rethrow_exception(fault);
  return code;
}

Usage run_usage() {
  auto texts = std::make_shared<RunTexts>();
  Usage usage{.name = "run", .summary = "Run scenarios, score the detectors, hold scores against gates"};
  usage.flags = {
      {"SCENARIO", "", "Names of the library, patterns such as 'noise_*', or YAML files", &texts->scenarios},
      {"--all", "", "The whole library", &texts->all},
      {"--laser", "SPEC", "sim, log:FILE, sick:PORT, scip:PORT or cola:HOST", &texts->laser},
      {"--truth", "FILE", "Truth of a device's scans, as emulate writes it", &texts->truth},
      texts->seeds.flag(),
      texts->jobs.flag(),
      {"--json", "FILE", "Write results as JSON; - is standard output", &texts->json},
      {"--out", "DIR", "Write the scenario's pictures here", &texts->out},
      {"--track", "", "Follow people and cylinders, and score that too", &texts->track},
      {"--quiet", "", "No table", &texts->is_quiet},
      {"--tables", "", "Each run's own table before the summary of several", &texts->tables},
      texts->record.flag(),
      texts->backend.flag(),
      texts->detector.preset_flag(),
      texts->detector.config_flag(),
      texts->settings.flag(),
  };
  usage.footer = R"(Examples:
  scanbed run static_hallway
  scanbed run static_hallway --seed 7 --set sensor.noise.sigma=0.012 --json -
  scanbed run --all
  scanbed run 'noise_*' crowd --seed 1..20 --jobs 2
  scanbed run my_hall.yaml --preset paper --set line_err=0.02 --out pictures
)" + table_two_text();
  usage.command = [texts] { return to_run(*texts); };
  return usage;
}

}  // namespace scanbed::scenarios
