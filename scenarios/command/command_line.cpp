// SPDX-License-Identifier: MIT
#include "scenarios/command/command_line.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>

#include "core/detect/table_two.hpp"
#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/report/version.hpp"

namespace scanbed::scenarios {
namespace {

// Flags as they are typed; checked and converted after parsing, so that all errors read alike.
struct TypedFlags {
  std::vector<std::string> scenarios;
  std::string laser = "sim";
  std::string seed;
  std::string preset = "paper";
  std::string config;
  std::vector<std::string> settings;
  std::string json;
  std::string out;
  std::string record;
  std::vector<std::string> recordings;
  std::string limit;
  std::string at = "0";
  std::string view = "camera";
  std::string size = "960x720";
  std::string backend = "planar";
  std::string mjcf;
  std::string grid = "none";
  bool no_beams = false;
  bool no_features = false;
  bool truth = false;
  bool labels = false;
  std::string gif;
  std::string mp4;
  std::string from = "0";
  std::string to;
  std::string frames_per_s;
  std::string truth_file;
  std::string link;
  std::string address = "0";
  std::string baud = "9600";
  std::string duration;
  std::vector<std::string> faults;
  std::vector<std::string> ports;
  bool quiet = false;
  bool unpaced = false;
  bool probe = false;
};

std::string table_two_text() {
  std::string text = "Detector parameters (paper, Table II) for --set and --config:\n";
  for (const TableTwoEntry& entry : table_two()) {
    const std::string unit = entry.unit.empty() ? "" : fmt::format(" {}", entry.unit);
    text += fmt::format("  {:<16} {} (default {}{})\n", entry.name, entry.meaning, entry.default_value, unit);
  }
  return text;
}

constexpr const char* kMainHelp = R"(Examples:
  scanbed list
  scanbed run static_hallway --out pictures
  scanbed detect --laser log:FILE.log > features.jsonl
'scanbed COMMAND --help' tells more.
Exit codes: 0 fine, 1 a gate was missed, 2 bad input or usage, 3 device or I/O fault, 130 interrupted.)";
constexpr const char* kRunHelp = R"(Examples:
  scanbed run static_hallway
  scanbed run static_hallway --seed 7 --set sensor.noise.sigma=0.012 --json -
  scanbed run my_hall.yaml --set line_err=0.02 --out pictures
)";
constexpr const char* kDetectHelp =
    R"(Prints one JSON object a scan, in metres and radians of the sensor's frame.
Examples:
  scanbed detect --laser log:hall.log.gz --limit 10
  scanbed detect --laser 'log:hall.log?only=FLASER&no_return=81.83' --set circle_std_max=0.1
  scanbed detect --laser sim:static_hallway --out features.jsonl
  scanbed detect --laser 'log:walk.bag?speed=1&from=2&to=10' --record walk.mcap
)";
constexpr const char* kRenderHelp = R"(Example:
  scanbed render static_hallway --at 20 --view top -o hall.png --size 1280x960
  scanbed render static_hallway --view top --grid polar --truth --labels --gif hall.gif --to 10)";
constexpr const char* kConvertHelp =
    R"(Formats, by ending: .jsonl (keeps everything), .mcap, .bag (ROS 1), .log .clf (CARMEN), .player .plog;
.gz behind a text format packs it. Reading goes by content.
Examples:
  scanbed convert hall.log hall.mcap
  scanbed convert 'walk.bag?only=/scan&from=2&to=10' walk.jsonl.gz
  scanbed convert killed.mcap.part whole.mcap)";
constexpr const char* kExportHelp = R"(Example:
  scanbed export static_hallway --mjcf hall.xml)";
constexpr const char* kEmulateHelp =
    R"(Prints the port, then serves it. The world begins anew where the scenario ends.
Faults: garbage, half, flip, blind_pair, nak, miss, refuse, silence, reboot, unplug, pollution.
Examples:
  scanbed emulate static_hallway --link /tmp/lms --truth truth.jsonl
  scanbed run static_hallway --laser sick:/tmp/lms --truth truth.jsonl
  scanbed emulate static_hallway --link /tmp/lms --fault flip@3 --fault reboot@10)";
constexpr const char* kDevicesHelp = R"(Examples:
  scanbed devices
  scanbed devices --probe /dev/ttyUSB0)";
constexpr const char* kValidateHelp = R"(Example:
  scanbed validate my_hall.yaml static_hallway)";

// A flag that may be repeated and takes one value each time, so that scenarios may follow it.
void add_settings(CLI::App& app, TypedFlags& flags) {
  app.add_option("--set", flags.settings,
                 "Change one value: PATH of a scenario file, or a detector parameter")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_detector(CLI::App& app, TypedFlags& flags) {
  app.add_option("--preset", flags.preset, "Detectors: paper or robust")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--config", flags.config, "YAML file of detector parameters")->type_name("FILE");
  add_settings(app, flags);
}

void add_record(CLI::App& app, TypedFlags& flags) {
  app.add_option("--record", flags.record, "Write scans, features and truth; the ending is the format")
      ->type_name("FILE");
}

void add_backend(CLI::App& app, TypedFlags& flags) {
  app.add_option("--backend", flags.backend, "Engine of simulated lasers: planar or spatial")
      ->type_name("NAME")
      ->capture_default_str();
}

CLI::App* add_run(CLI::App& app, TypedFlags& flags) {
  CLI::App* run = app.add_subcommand("run", "Run scenarios, score the detectors, hold scores against gates");
  run->add_option("SCENARIO", flags.scenarios, "Names of the library or YAML files")
      ->required()
      ->type_name("");
  run->add_option("--laser", flags.laser, "sim, log:FILE, sick:PORT, scip:PORT or cola:HOST")
      ->type_name("SPEC")
      ->capture_default_str();
  run->add_option("--truth", flags.truth_file, "Truth of a device's scans, as emulate writes it")
      ->type_name("FILE");
  run->add_option("--seed", flags.seed, "In place of the scenario's own")->type_name("N");
  run->add_option("--json", flags.json, "Write results as JSON; - is standard output")->type_name("FILE");
  run->add_option("--out", flags.out, "Write the scenario's pictures here")->type_name("DIR");
  run->add_flag("--quiet", flags.quiet, "No table");
  add_record(*run, flags);
  add_backend(*run, flags);
  add_detector(*run, flags);
  run->footer(kRunHelp + table_two_text());
  return run;
}

CLI::App* add_detect(CLI::App& app, TypedFlags& flags) {
  CLI::App* detect = app.add_subcommand("detect", "Print the features of each scan as JSON Lines");
  detect
      ->add_option("--laser", flags.laser,
                   "log:FILE[?only=NAME&no_return=METRES&speed=X&from=S&to=S], sim:SCENARIO, "
                   "sick:PORT[?baud=38400&fov_deg=180&resolution_deg=0.5&unit=mm], scip:PORT or cola:HOST")
      ->type_name("SPEC")
      ->required();
  detect->add_option("--limit", flags.limit, "Stop after N scans")->type_name("N");
  detect->add_option("--out", flags.out, "In place of standard output")->type_name("FILE");
  add_record(*detect, flags);
  add_backend(*detect, flags);
  add_detector(*detect, flags);
  detect->footer(kDetectHelp + table_two_text());
  return detect;
}

CLI::App* add_render(CLI::App& app, TypedFlags& flags) {
  CLI::App* render = app.add_subcommand("render", "Paint a moment of a scenario: scene, scan and features");
  render->add_option("SCENARIO", flags.scenarios, "Name of the library or YAML file")
      ->required()
      ->expected(1)
      ->type_name("");
  render->add_option("--at", flags.at, "Seconds from the start")->type_name("T")->capture_default_str();
  render->add_option("--view", flags.view, "top, camera or laser")->type_name("VIEW")->capture_default_str();
  render->add_option("-o,--out", flags.out, "PNG file")->type_name("FILE");
  render->add_option("--gif", flags.gif, "Film, needs ffmpeg")->type_name("FILE");
  render->add_option("--mp4", flags.mp4, "Film, needs ffmpeg")->type_name("FILE");
  render->add_option("--from", flags.from, "Start of a film")->type_name("T")->capture_default_str();
  render->add_option("--to", flags.to, "End of a film; else the scenario's")->type_name("T");
  render->add_option("--fps", flags.frames_per_s, "Pictures a second; else one a scan")->type_name("N");
  render->add_option("--grid", flags.grid, "none, cartesian or polar")
      ->type_name("GRID")
      ->capture_default_str();
  render->add_flag("--no-beams", flags.no_beams, "Echoes without the beams to them");
  render->add_flag("--no-features", flags.no_features, "Without what the detectors found");
  render->add_flag("--truth", flags.truth, "Outlines of what is truly there");
  render->add_flag("--labels", flags.labels, "Names of what is truly there");
  render->add_option("--size", flags.size, "Pixels")->type_name("WxH")->capture_default_str();
  render->add_option("--seed", flags.seed, "In place of the scenario's own")->type_name("N");
  add_backend(*render, flags);
  add_detector(*render, flags);
  render->footer(kRenderHelp);
  return render;
}

CLI::App* add_convert(CLI::App& app, TypedFlags& flags) {
  CLI::App* convert = app.add_subcommand("convert", "Write a recording in another format");
  convert
      ->add_option("FILES", flags.recordings, "What to read, with options as behind log:, and what to write")
      ->required()
      ->expected(2)
      ->type_name("");
  convert->footer(kConvertHelp);
  return convert;
}

CLI::App* add_export(CLI::App& app, TypedFlags& flags) {
  CLI::App* command = app.add_subcommand("export", "Write a scenario's world for other programs");
  command->add_option("SCENARIO", flags.scenarios, "Name of the library or YAML file")
      ->required()
      ->expected(1)
      ->type_name("");
  command->add_option("--mjcf", flags.mjcf, "MuJoCo's model format; - is standard output")
      ->type_name("FILE")
      ->required();
  command->add_option("--seed", flags.seed, "In place of the scenario's own")->type_name("N");
  add_settings(*command, flags);
  command->footer(kExportHelp);
  return command;
}

CLI::App* add_emulate(CLI::App& app, TypedFlags& flags) {
  CLI::App* emulate = app.add_subcommand("emulate", "Be an LMS 200 in a scenario's world, at a serial port");
  emulate->add_option("SCENARIO", flags.scenarios, "Name of the library or YAML file")
      ->required()
      ->expected(1)
      ->type_name("");
  emulate->add_option("--link", flags.link, "Name for the port")->type_name("PATH");
  emulate->add_option("--truth", flags.truth_file, "Write truth of each scan that is sent")
      ->type_name("FILE");
  emulate->add_flag("--unpaced", flags.unpaced, "As fast as the host reads, not as fast as the link");
  emulate->add_option("--fault", flags.faults, "Something goes wrong at a time; may be repeated")
      ->type_name("NAME@SECONDS")
      ->allow_extra_args(false);
  emulate->add_option("--address", flags.address, "Of the sensor: 0 or 1")
      ->type_name("N")
      ->capture_default_str();
  emulate->add_option("--baud", flags.baud, "After power-on")->type_name("BAUD")->capture_default_str();
  emulate->add_option("--for", flags.duration, "End after so many seconds")->type_name("SECONDS");
  emulate->add_option("--seed", flags.seed, "In place of the scenario's own")->type_name("N");
  add_settings(*emulate, flags);
  emulate->footer(kEmulateHelp);
  return emulate;
}

CLI::App* add_devices(CLI::App& app, TypedFlags& flags) {
  CLI::App* devices = app.add_subcommand("devices", "List serial ports, and what is at them");
  devices->add_option("PORT", flags.ports, "These alone")->type_name("");
  devices->add_flag("--probe", flags.probe, "Ask each port for an LMS; sends bytes to whatever is there");
  devices->footer(kDevicesHelp);
  return devices;
}

CLI::App* add_validate(CLI::App& app, TypedFlags& flags) {
  CLI::App* validate = app.add_subcommand("validate", "Check scenario files without running them");
  validate->add_option("FILE", flags.scenarios, "YAML files or names of the library")
      ->required()
      ->type_name("");
  validate->footer(kValidateHelp);
  return validate;
}

std::int64_t to_count(std::string_view flag, const std::string& text, std::int64_t least) {
  const std::optional<std::int64_t> count = parse_count(text);
  if (!count) throw InputError(fmt::format("{}: expected a whole number, found {}", flag, quote(text)));
  require(*count >= least, flag, static_cast<double>(*count), fmt::format(">= {}", least));
  return *count;
}

std::optional<std::uint64_t> to_seed(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return static_cast<std::uint64_t>(to_count("--seed", text, 0));
}

std::optional<std::filesystem::path> to_path(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::filesystem::path>(text);
}

std::vector<Setting> to_settings(const TypedFlags& flags) {
  std::vector<Setting> settings;
  for (const std::string& text : flags.settings) settings.push_back(parse_setting(text));
  return settings;
}

sim::View to_view(const std::string& text) {
  static const std::array<std::string, 3> kViews = {"top", "camera", "laser"};
  if (text == kViews[0]) return sim::View::kTop;
  if (text == kViews[1]) return sim::View::kCamera;
  if (text == kViews[2]) return sim::View::kLaser;
  throw InputError(fmt::format("--view: unknown value {}{}", quote(text), name_hint(text, kViews, "views")));
}

sim::Grid to_grid(const std::string& text) {
  static const std::array<std::string, 3> kGrids = {"none", "cartesian", "polar"};
  if (text == kGrids[0]) return sim::Grid::kNone;
  if (text == kGrids[1]) return sim::Grid::kCartesian;
  if (text == kGrids[2]) return sim::Grid::kPolar;
  throw InputError(fmt::format("--grid: unknown value {}{}", quote(text), name_hint(text, kGrids, "grids")));
}

sim::PictureOptions to_picture(const TypedFlags& flags) {
  constexpr std::int64_t kLargest_px = 8192;
  const std::size_t cross = std::min(flags.size.find('x'), flags.size.size());
  const std::optional<std::int64_t> width = parse_count(flags.size.substr(0, cross));
  const std::optional<std::int64_t> height =
      parse_count(std::string_view(flags.size).substr(std::min(cross + 1, flags.size.size())));
  if (!width || !height || *width > kLargest_px || *height > kLargest_px) {
    throw InputError(fmt::format("--size: expected WIDTHxHEIGHT in pixels of at most {}, found {}",
                                 kLargest_px, quote(flags.size)));
  }
  sim::PictureOptions picture{.width_px = static_cast<int>(*width),
                              .height_px = static_cast<int>(*height),
                              .view = to_view(flags.view)};
  picture.grid = to_grid(flags.grid);
  picture.beams = !flags.no_beams;
  picture.features = !flags.no_features;
  picture.truth = flags.truth;
  picture.labels = flags.labels;
  picture.validate();
  return picture;
}

double to_time_s(std::string_view flag, const std::string& text) {
  const std::optional<double> time_s = parse_number(text);
  if (!time_s) throw InputError(fmt::format("{}: expected seconds, found {}", flag, quote(text)));
  return *time_s;
}

FilmOptions to_film(const TypedFlags& flags) {
  FilmOptions film{.gif = to_path(flags.gif), .mp4 = to_path(flags.mp4)};
  film.from_s = to_time_s("--from", flags.from);
  if (!flags.to.empty()) film.to_s = to_time_s("--to", flags.to);
  if (!flags.frames_per_s.empty()) {
    const std::optional<double> rate = parse_number(flags.frames_per_s);
    if (!rate) throw InputError(fmt::format("--fps: expected a number, found {}", quote(flags.frames_per_s)));
    require(*rate > 0.0 && *rate <= 60.0, "--fps", *rate, "(0, 60]");
    film.frames_per_s = *rate;
  }
  return film;
}

DetectorChoice to_detector(const TypedFlags& flags) {
  return {.preset = flags.preset, .config = to_path(flags.config)};
}

sim::Backend to_backend(const TypedFlags& flags) {
  static const std::array<std::string, 2> kBackends = {"planar", "spatial"};
  if (std::find(kBackends.begin(), kBackends.end(), flags.backend) == kBackends.end()) {
    throw InputError(fmt::format("--backend: unknown value {}{}", quote(flags.backend),
                                 name_hint(flags.backend, kBackends, "engines")));
  }
  return sim::parse_backend(flags.backend);
}

RunCommand to_run(const TypedFlags& flags) {
  return {.scenarios = flags.scenarios,
          .laser = parse_laser_spec(flags.laser),
          .seed = to_seed(flags.seed),
          .detector = to_detector(flags),
          .settings = to_settings(flags),
          .json = to_path(flags.json),
          .out = to_path(flags.out),
          .record = to_path(flags.record),
          .truth = to_path(flags.truth_file),
          .quiet = flags.quiet,
          .backend = to_backend(flags)};
}

DetectCommand to_detect(const TypedFlags& flags) {
  std::optional<std::int64_t> limit;
  if (!flags.limit.empty()) limit = to_count("--limit", flags.limit, 1);
  return {.laser = parse_laser_spec(flags.laser),
          .detector = to_detector(flags),
          .settings = to_settings(flags),
          .limit = limit,
          .out = to_path(flags.out),
          .record = to_path(flags.record),
          .backend = to_backend(flags)};
}

RenderCommand to_render(const TypedFlags& flags) {
  if (flags.out.empty() && flags.gif.empty() && flags.mp4.empty()) {
    throw InputError("nothing to write: name a file with -o, --gif or --mp4; see 'scanbed render --help'");
  }
  return {.scenario = flags.scenarios.front(),
          .at_s = to_time_s("--at", flags.at),
          .picture = to_picture(flags),
          .out = to_path(flags.out),
          .film = to_film(flags),
          .seed = to_seed(flags.seed),
          .detector = to_detector(flags),
          .settings = to_settings(flags),
          .backend = to_backend(flags)};
}

ExportCommand to_export(const TypedFlags& flags) {
  return {.scenario = flags.scenarios.front(),
          .mjcf = flags.mjcf,
          .seed = to_seed(flags.seed),
          .settings = to_settings(flags)};
}

EmulateCommand to_emulate(const TypedFlags& flags) {
  EmulateCommand command{.scenario = flags.scenarios.front(),
                         .link = flags.link,
                         .truth = to_path(flags.truth_file),
                         .is_unpaced = flags.unpaced,
                         .seed = to_seed(flags.seed),
                         .settings = to_settings(flags)};
  for (const std::string& fault : flags.faults) command.faults.push_back(hw::parse_lms_fault(fault));
  const std::int64_t address = to_count("--address", flags.address, 0);
  require(address <= 127, "--address", static_cast<double>(address), "[0, 127]");
  command.address = static_cast<std::uint8_t>(address);
  command.baud = static_cast<int>(std::min<std::int64_t>(to_count("--baud", flags.baud, 1), 1000000));
  if (!flags.duration.empty()) command.duration_s = to_time_s("--for", flags.duration);
  return command;
}

// The parser would only say that a subcommand is missing.
void check_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  throw InputError(fmt::format("unknown command {}{}; see 'scanbed --help'", quote(argv[1]),
                               name_hint(argv[1], names, "commands")));
}

// The parser's messages are one line without a full stop; where the help is tells the user what to do.
[[noreturn]] void refuse_usage(const CLI::App& app, const CLI::ParseError& error) {
  std::string name = "scanbed";
  for (const CLI::App* chosen : app.get_subcommands()) name += " " + chosen->get_name();
  throw InputError(fmt::format("{}; see '{} --help'", error.what(), name));
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv) {
  TypedFlags flags;
  CLI::App app("A testbed for feature detectors on 2D laser scans.", "scanbed");
  app.set_version_flag("--version", fmt::format("scanbed {}", kVersion));
  app.require_subcommand(1);
  app.footer(kMainHelp);
  const CLI::App* run = add_run(app, flags);
  const CLI::App* detect = add_detect(app, flags);
  const CLI::App* render = add_render(app, flags);
  const CLI::App* convert = add_convert(app, flags);
  const CLI::App* exported = add_export(app, flags);
  const CLI::App* list = app.add_subcommand("list", "List the scenarios of the library");
  const CLI::App* emulate = add_emulate(app, flags);
  const CLI::App* devices = add_devices(app, flags);
  add_validate(app, flags);
  check_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    return TextCommand{std::string(version.what()) + "\n"};
  } catch (const CLI::CallForHelp&) {
    return TextCommand{app.help()};
  } catch (const CLI::ParseError& error) {
    refuse_usage(app, error);
  }
  if (run->parsed()) return to_run(flags);
  if (detect->parsed()) return to_detect(flags);
  if (render->parsed()) return to_render(flags);
  if (convert->parsed()) {
    return ConvertCommand{parse_laser_spec("log:" + flags.recordings[0]), flags.recordings[1]};
  }
  if (exported->parsed()) return to_export(flags);
  if (list->parsed()) return ListCommand{};
  if (emulate->parsed()) return to_emulate(flags);
  if (devices->parsed()) return DevicesCommand{flags.ports, flags.probe};
  return ValidateCommand{flags.scenarios};
}

}  // namespace scanbed::scenarios
