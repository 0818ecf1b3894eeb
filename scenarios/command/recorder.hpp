// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/detect/features.hpp"
#include "core/scan/range_sensor.hpp"
#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::scenarios {

/// What `--record FILE` does, or nothing where it was not given. Each scan is safe from a kill of the program
/// within a second of the scans' time; see hw/recording.
class Recorder {
 public:
  /// @throws InputError where the file's ending is of no format; hw::WriteFault where it cannot be made.
  Recorder(const std::optional<std::filesystem::path>& path, const hw::RecordingMetadata& metadata);

  /// Records the scan that the sensor gave last, with its truth where there is one.
  void see(const LaserScan& scan, const Features& features, const RangeSensor& sensor);

  /// Ends the recording and gives the file its name; not one of which a part could not be written.
  void finish();

 private:
  std::unique_ptr<hw::ScanWriter> writer_;
};

/// Metadata of a recording: which program wrote it, and the laser as `--laser` names it.
hw::RecordingMetadata recording_metadata(const std::string& laser, const std::string& preset);

/// Adds a scenario's seed and the text of its file.
void add_scenario(hw::RecordingMetadata& metadata, const std::string& name_or_path, std::uint64_t seed);

}  // namespace scanbed::scenarios
