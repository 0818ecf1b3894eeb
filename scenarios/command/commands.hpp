// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hw/sick/emulator_options.hpp"
#include "scenarios/load/set_path.hpp"
#include "scenarios/run/detector_settings.hpp"
#include "scenarios/run/laser_spec.hpp"
#include "sim/engine/make_engine.hpp"
#include "sim/render/scene_picture.hpp"

namespace scanbed::scenarios {

/// What the program ends with.
enum ExitCode : int {
  kExitFine = 0,
  kExitGateMissed = 1,
  kExitBadInput = 2,
  kExitFault = 3,
  kExitInterrupted = 130,  ///< by SIGINT; main makes it 143 where it was SIGTERM, 129 where SIGHUP
};

// What the command line asks for, one struct a subcommand, with values already checked; and what does it. All
// throw InputError, SensorFault or OutputFault for main to turn into an exit code.

/// Seeds from the first to the last.
struct SeedRange {
  std::uint64_t first = 1;
  std::uint64_t last = 1;

  int count() const { return static_cast<int>(last - first) + 1; }
};

/// `scanbed run SCENARIO...`
struct RunCommand {
  std::vector<std::string> scenarios;  ///< names, patterns of names, files
  LaserSpec laser;
  std::optional<SeedRange> seeds;  ///< each scenario runs once for each; empty: with its own
  int num_workers = 1;             ///< runs at the same time
  DetectorChoice detector;
  std::vector<Setting> settings;  ///< of the scenario; Table II names go to the detector
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> out;     ///< folder for pictures
  std::optional<std::filesystem::path> record;  ///< recording to write
  std::optional<std::filesystem::path> truth;   ///< of scans that come from a device
  bool quiet = false;
  bool tables = false;                           ///< each run's own table, where there are several
  bool track = false;                            ///< score what was followed, too
  sim::Backend backend = sim::Backend::kPlanar;  ///< of simulated lasers
};

/// `scanbed detect --laser SPEC`
struct DetectCommand {
  LaserSpec laser;
  DetectorChoice detector;
  std::vector<Setting> settings;
  std::optional<std::int64_t> limit;  ///< scans
  bool track = false;                 ///< follow people, legs and cylinders
  bool interpret = false;             ///< say what the scene is
  std::optional<std::filesystem::path> out;
  std::optional<std::filesystem::path> record;   ///< recording to write
  sim::Backend backend = sim::Backend::kPlanar;  ///< of simulated lasers
};

/// Films beside, or in place of, a picture.
struct FilmOptions {
  std::optional<std::filesystem::path> gif;
  std::optional<std::filesystem::path> mp4;
  double from_s = 0.0;
  std::optional<double> to_s;          ///< empty: the scenario's end
  std::optional<double> frames_per_s;  ///< of the film; empty: one a scan, as fast as they were measured
};

/// `scanbed render SCENARIO --at T --view V -o F.png`
struct RenderCommand {
  std::string scenario;
  double at_s = 0.0;
  sim::PictureOptions picture;
  std::optional<std::filesystem::path> out;  ///< PNG
  FilmOptions film;
  std::optional<std::uint64_t> seed;
  DetectorChoice detector;
  std::vector<Setting> settings;
  sim::Backend backend = sim::Backend::kPlanar;
};

/// `scanbed export SCENARIO --mjcf F`
struct ExportCommand {
  std::string scenario;
  std::filesystem::path mjcf;  ///< - is standard output
  std::optional<std::uint64_t> seed;
  std::vector<Setting> settings;
};

/// `scanbed convert FILE[?OPTIONS] FILE`
struct ConvertCommand {
  LaserSpec from;  ///< a recording
  std::filesystem::path to;
};

/// `scanbed emulate SCENARIO --link PATH`
struct EmulateCommand {
  std::string scenario;
  std::filesystem::path link;  ///< empty: the port has its own name alone
  std::optional<std::filesystem::path> truth;
  bool is_unpaced = false;
  std::vector<hw::LmsFault> faults;
  std::uint8_t address = 0;
  int baud = 9600;
  std::optional<double> duration_s;  ///< empty: until it is interrupted
  std::optional<std::uint64_t> seed;
  sim::Backend backend = sim::Backend::kPlanar;
  std::vector<Setting> settings;
};

/// `scanbed devices [--probe] [PORT...]`
struct DevicesCommand {
  std::vector<std::string> ports;  ///< empty: all that the system knows
  bool is_probing = false;
};

/// `scanbed options`
struct OptionsCommand {
  DetectorChoice detector;
  std::vector<Setting> settings;
};

/// `scanbed list`
struct ListCommand {};

/// `scanbed validate FILE...`
struct ValidateCommand {
  std::vector<std::string> scenarios;
};

/// `scanbed schema`
struct SchemaCommand {};

/// `--help`, `--version`: a text for stdout.
struct TextCommand {
  std::string text;
};

using Command =
    std::variant<RunCommand, DetectCommand, RenderCommand, ConvertCommand, ExportCommand, EmulateCommand,
                 DevicesCommand, OptionsCommand, ListCommand, ValidateCommand, SchemaCommand, TextCommand>;

ExitCode execute(const RunCommand& command);
ExitCode execute(const DetectCommand& command);
ExitCode execute(const RenderCommand& command);
ExitCode execute(const ConvertCommand& command);
ExitCode execute(const ExportCommand& command);
ExitCode execute(const EmulateCommand& command);
ExitCode execute(const DevicesCommand& command);
ExitCode execute(const OptionsCommand& command);
ExitCode execute(const ListCommand& command);
ExitCode execute(const ValidateCommand& command);
ExitCode execute(const SchemaCommand& command);
ExitCode execute(const TextCommand& command);

}  // namespace scanbed::scenarios
