// SPDX-License-Identifier: MIT
#include "scenarios/command/recorder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "hw/recording/open_recording.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/report/version.hpp"

namespace scanbed::scenarios {

Recorder::Recorder(const std::optional<std::filesystem::path>& path, const hw::RecordingMetadata& metadata) {
  if (path) writer_ = hw::create_recording(*path, metadata);
}

void Recorder::see(const LaserScan& scan, const Features& features, const RangeSensor& sensor) {
  if (!writer_) return;
  try {
    writer_->write({.scan = scan, .features = &features, .truth = sensor.truth()});
  } catch (...) {
    writer_.reset();  // a recording with a hole must not get its name
    throw;
  }
}

void Recorder::finish() {
  if (writer_) writer_->finish();
  writer_.reset();
}

hw::RecordingMetadata recording_metadata(const std::string& laser, const std::string& preset) {
  return {{"program", fmt::format("scanbed {}", kVersion)}, {"laser", laser}, {"preset", preset}};
}

void add_scenario(hw::RecordingMetadata& metadata, const std::string& name_or_path, std::uint64_t seed) {
  metadata["scenario"] = name_or_path;
  metadata["seed"] = std::to_string(seed);
  std::ifstream file(find_scenario(name_or_path), std::ios::binary);
  metadata["configuration"] = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace scanbed::scenarios
