// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <exception>
#include <memory>

#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "hw/recording/open_recording.hpp"
#include "scenarios/command/commands.hpp"
#include "scenarios/command/flag_values.hpp"
#include "scenarios/command/interrupt.hpp"
#include "scenarios/command/log.hpp"
#include "scenarios/command/open_laser.hpp"
#include "scenarios/command/progress.hpp"
#include "scenarios/command/usage.hpp"

namespace scanbed::scenarios {
namespace {

// What ended it early: a recording that is cut off. What came before is to be written all the same.
std::exception_ptr copy_scans(hw::ScanReader& reader, hw::ScanWriter& writer) {
  Progress progress("convert");
  LaserScan scan;
  try {
    while (!is_interrupted() && reader.next(scan, {})) {
      writer.write({.scan = scan, .features = reader.features(), .truth = reader.truth()});
      progress.show(scan.index + 1);
    }
  } catch (const InputError&) {
    return std::current_exception();
  } catch (const SensorFault&) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

ExitCode execute(const ConvertCommand& command) {
  const std::unique_ptr<hw::ScanReader> reader = open_log(command.from);
  const std::unique_ptr<hw::ScanWriter> writer = hw::create_recording(command.to, reader->metadata());
  const std::exception_ptr fault = copy_scans(*reader, *writer);
  writer->finish();
  log_note(to_text(reader->counts()));
  if (fault) {
    log_note(fmt::format("{} holds the scans up to there", command.to.string()));
    std::rethrow_exception(fault);
  }
  return is_interrupted() ? kExitInterrupted : kExitFine;
}

Usage convert_usage() {
  auto files = std::make_shared<std::vector<std::string>>();
  Usage usage{.name = "convert", .summary = "Write a recording in another format"};
  usage.flags = {
      {"FILES", "", "What to read, with options as behind log:, and what to write", files.get(), true, 2}};
  usage.footer =
      R"(Formats, by ending: .jsonl (keeps everything), .mcap, .bag (ROS 1), .log .clf (CARMEN), .player .plog;
.gz behind a text format packs it. Reading goes by content. Lines and records that are damaged are told of and left out. A
recording that cannot be read to its end becomes a whole one of the scans up to there; the exit code is 2 then.
Examples:
  scanbed convert hall.log hall.mcap
  scanbed convert 'walk.bag?only=/scan&from=2&to=10' walk.jsonl.gz
  scanbed convert killed.mcap.part whole.mcap)";
  usage.command = [files] {
    LaserSpec from = parse_laser_spec("log:" + files->front());
    check_files(std::array{FlagFile{"FILES", files->back()}}, std::array{FlagFile{"convert", from.target}});
    return ConvertCommand{std::move(from), files->back()};
  };
  return usage;
}

}  // namespace scanbed::scenarios
