// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/detect/feature_detector.hpp"
#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/shared_flags.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/place.hpp"
#include "scenarios/report/video_file.hpp"
#include "scenarios/run/output.hpp"
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

// Films of one run, a picture for each moment.
class Films {
 public:
  Films(const RenderCommand& command, double frames_per_s) {
    const auto add = [&](const std::optional<std::filesystem::path>& path, VideoFormat format) {
      if (!path) return;
      check_folder(*path);
      files_.push_back(std::make_unique<VideoFile>(
          *path, VideoOptions{format, command.picture.width_px, command.picture.height_px, frames_per_s}));
      paths_.push_back(*path);
    };
    add(command.film.gif, VideoFormat::kGif);
    add(command.film.mp4, VideoFormat::kMp4);
  }

  void write(const sim::Image& image) {
    for (const auto& file : files_) file->write(image);
  }

  std::string finish() {
    std::string text;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      files_[i]->finish();
      text += "film: " + paths_[i].string() + "\n";
    }
    return text;
  }

 private:
  std::vector<std::unique_ptr<VideoFile>> files_;
  std::vector<std::filesystem::path> paths_;
};

// A picture of each moment in time, whatever the rate of the scans: it shows the scan that was last then.
ExitCode render_film(const RenderCommand& command, const Scenario& scenario, FeatureDetector& detector) {
  const double to_s = command.film.to_s.value_or(scenario.duration_s);
  const double from_s = command.film.from_s;
  require(from_s >= 0.0 && from_s < scenario.duration_s, "--from", from_s,
          fmt::format("[0, {}), within the scenario", scenario.duration_s));
  require(to_s > from_s && to_s <= scenario.duration_s, "--to", to_s,
          fmt::format("({}, {}]", from_s, scenario.duration_s));
  const double frames_per_s = command.film.frames_per_s.value_or(1.0 / scenario.lms.scan_period_s);
  Films films(command, frames_per_s);
  const std::unique_ptr<sim::SimulatedLms> sensor = simulate(scenario, command.backend, detector.options());
  sim::ScenePainter painter(sensor->world(), command.picture);
  Progress progress("film");
  LaserScan scan;
  const auto num_pictures = static_cast<std::int64_t>(std::ceil((to_s - from_s) * frames_per_s - 1e-9));
  sim::Image image;
  std::int64_t painted_scan = -1;
  for (std::int64_t k = 0; k < num_pictures && !is_interrupted(); ++k) {
    const double time_s = from_s + static_cast<double>(k) / frames_per_s;
    while (scan.range_m.empty() || !shows(scenario, scan, time_s)) {
      if (!sensor->next(scan, kNoWait)) break;
    }
    if (scan.index != painted_scan) {
      const Features& features = detector.detect(scan);
      image = painter.paint(sensor->state(), {scan, features, sensor->truth()}, caption(scenario, scan));
      painted_scan = scan.index;
    }
    films.write(image);
    progress.show(k + 1);
  }
  if (is_interrupted()) return kExitInterrupted;
  write_whole(std::nullopt, films.finish());
  return kExitFine;
}

ExitCode render_picture(const RenderCommand& command, const Scenario& scenario, FeatureDetector& detector) {
  require(command.at_s >= 0.0 && command.at_s <= scenario.duration_s, "--at", command.at_s,
          fmt::format("[0, {}], the scenario's duration", scenario.duration_s));
  check_folder(*command.out);
  const std::unique_ptr<sim::SimulatedLms> sensor = simulate(scenario, command.backend, detector.options());
  const LaserScan scan = scan_at(scenario, *sensor, command.at_s);
  if (is_interrupted()) return kExitInterrupted;
  const Features& features = detector.detect(scan);
  sim::ScenePainter painter(sensor->world(), command.picture);
  const sim::Image image =
      painter.paint(sensor->state(), {scan, features, sensor->truth()}, caption(scenario, scan));
  const std::string png = sim::png_of(image);
  if (is_interrupted()) return kExitInterrupted;
  write_whole(command.out, png);
  if (*command.out != "-") write_whole(std::nullopt, "picture: " + command.out->string() + "\n");
  return kExitFine;
}

struct RenderTexts {
  std::vector<std::string> scenarios;
  std::string at = "0";
  std::string view = "camera";
  std::string out;
  std::string gif;
  std::string mp4;
  std::string from = "0";
  std::string to;
  std::string frames_per_s;
  std::string grid = "none";
  bool no_beams = false;
  bool no_features = false;
  bool truth = false;
  bool labels = false;
  std::string size = "960x720";
  SeedFlag seed;
  BackendFlag backend;
  DetectorFlags detector;
  SettingFlag settings;
};

sim::View to_view(const std::string& text) {
  return static_cast<sim::View>(to_choice("--view", text, view_names(), "views"));
}

sim::Grid to_grid(const std::string& text) {
  static const std::array<std::string, 3> kNames = {"none", "cartesian", "polar"};
  return static_cast<sim::Grid>(to_choice("--grid", text, kNames, "grids"));
}

sim::PictureOptions to_picture(const RenderTexts& texts) {
  const auto fits = [](const std::optional<std::int64_t>& size_px) {
    return size_px && *size_px >= sim::PictureOptions::kLeast_px && *size_px <= sim::PictureOptions::kMost_px;
  };
  const std::string& size = texts.size;
  const std::size_t cross = std::min(size.find('x'), size.size());
  const std::optional<std::int64_t> width = parse_count(size.substr(0, cross));
  const std::optional<std::int64_t> height =
      parse_count(std::string_view(size).substr(std::min(cross + 1, size.size())));
  if (!fits(width) || !fits(height)) {
    throw InputError(fmt::format("--size: expected WIDTHxHEIGHT, each of {} to {} pixels, found {}",
                                 sim::PictureOptions::kLeast_px, sim::PictureOptions::kMost_px, quote(size)));
  }
  sim::PictureOptions picture{.width_px = static_cast<int>(*width),
                              .height_px = static_cast<int>(*height),
                              .view = to_view(texts.view)};
  picture.grid = to_grid(texts.grid);
  picture.beams = !texts.no_beams;
  picture.features = !texts.no_features;
  picture.truth = texts.truth;
  picture.labels = texts.labels;
  picture.validate();
  return picture;
}

FilmOptions to_film(const RenderTexts& texts) {
  FilmOptions film{.gif = to_path(texts.gif), .mp4 = to_path(texts.mp4)};
  film.from_s = to_time_s("--from", texts.from);
  if (!texts.to.empty()) film.to_s = to_time_s("--to", texts.to);
  if (!texts.frames_per_s.empty()) {
    const std::optional<double> rate = parse_number(texts.frames_per_s);
    if (!rate) throw InputError("--fps: expected a number, found " + quote(texts.frames_per_s));
    require(*rate > 0.0 && *rate <= 60.0, "--fps", *rate, "(0, 60]");
    film.frames_per_s = *rate;
  }
  return film;
}

// A name that says what it is must say what is written.
void check_ending(std::string_view flag, const std::string& file, std::string_view ending) {
  std::string found = std::filesystem::path(file).extension();
  std::transform(found.begin(), found.end(), found.begin(), [](unsigned char c) { return std::tolower(c); });
  if (found.empty() || found == ending) return;
  throw InputError(fmt::format("{}: expected a name that ends in {}, found {}", flag, ending, quote(file)));
}

// What is to be written, and that no flag asks for something else.
void check_outputs(const RenderTexts& texts) {
  const bool is_film = !texts.gif.empty() || !texts.mp4.empty();
  if (texts.out.empty() && !is_film) {
    throw InputError("nothing to write: name a file with -o, --gif or --mp4; see 'scanbed render --help'");
  }
  const RenderTexts unsaid;
  if (texts.out.empty() && texts.at != unsaid.at) {
    throw InputError("--at: only for pictures; write -o FILE, or --from and --to for a film");
  }
  const auto check_film_flag = [&](std::string_view flag, bool is_said) {
    if (is_film || !is_said) return;
    throw InputError(fmt::format("{}: only for films; write --gif FILE or --mp4 FILE", flag));
  };
  check_film_flag("--from", texts.from != unsaid.from);
  check_film_flag("--to", texts.to != unsaid.to);
  check_film_flag("--fps", texts.frames_per_s != unsaid.frames_per_s);
}

RenderCommand to_render(const RenderTexts& texts) {
  check_outputs(texts);
  check_ending("--out", texts.out, ".png");
  check_ending("--gif", texts.gif, ".gif");
  check_ending("--mp4", texts.mp4, ".mp4");
  std::vector<FlagFile> read = scenario_files(texts.scenarios);
  read.push_back(texts.detector.file());
  check_files(
      std::array{FlagFile{"--out", to_path(texts.out)}, FlagFile{"--gif", to_file("--gif", texts.gif)},
                 FlagFile{"--mp4", to_file("--mp4", texts.mp4)}},
      read);
  return {.scenario = texts.scenarios.front(),
          .at_s = to_time_s("--at", texts.at),
          .picture = to_picture(texts),
          .out = to_path(texts.out),
          .film = to_film(texts),
          .seed = texts.seed.value(),
          .detector = texts.detector.value(),
          .settings = texts.settings.values(),
          .backend = texts.backend.value()};
}

}  // namespace

ExitCode execute(const RenderCommand& command) {
  const SortedSettings settings = sort_settings(command.settings);
  constexpr AnalysisSteps kNone{.tracks = false, .interprets = false};
  FeatureDetector detector(open_detector(command.detector, settings.detector, kNone).detector);
  const Scenario scenario = open_scenario(command.scenario, settings.scenario, command.seed);
  if (command.out) {
    const ExitCode code = render_picture(command, scenario, detector);
    if (code != kExitFine) return code;
  }
  if (!command.film.gif && !command.film.mp4) return kExitFine;
  return render_film(command, scenario, detector);
}

Usage render_usage() {
  auto texts = std::make_shared<RenderTexts>();
  Usage usage{.name = "render", .summary = "Paint a moment of a scenario: scene, scan and features"};
  usage.flags = {
      one_scenario(texts->scenarios),
      {"--at", "T", "Seconds from the start", &texts->at},
      {"--view", "VIEW", "top, camera or laser", &texts->view},
      {"-o,--out", "FILE", "PNG file; - is standard output", &texts->out},
      {"--gif", "FILE", "Film, needs ffmpeg", &texts->gif},
      {"--mp4", "FILE", "Film, needs ffmpeg", &texts->mp4},
      {"--from", "T", "Start of a film", &texts->from},
      {"--to", "T", "End of a film; else the scenario's", &texts->to},
      {"--fps", "N", "Pictures a second; else one a scan", &texts->frames_per_s},
      {"--grid", "GRID", "none, cartesian or polar", &texts->grid},
      {"--no-beams", "", "Echoes without the beams to them", &texts->no_beams},
      {"--no-features", "", "Without what the detectors found", &texts->no_features},
      {"--truth", "", "Outlines of the walls, round things and legs that are truly there", &texts->truth},
      {"--labels", "", "Names of these", &texts->labels},
      {"--size", "WxH", "Pixels", &texts->size},
      texts->seed.flag(),
      texts->backend.flag(),
      texts->detector.preset_flag(),
      texts->detector.config_flag(),
      texts->settings.flag(),
  };
  usage.footer = R"(Example:
  scanbed render static_hallway --at 20 --view top -o hall.png --size 1280x960
  scanbed render static_hallway --view top --grid polar --truth --labels --gif hall.gif --to 10)";
  usage.command = [texts] { return to_render(*texts); };
  return usage;
}

}  // namespace scanbed::scenarios
