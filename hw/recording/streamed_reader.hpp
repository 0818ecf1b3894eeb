// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "hw/recording/recording_options.hpp"
#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_source.hpp"

namespace scanbed::hw {

/// The scans of a ScanSource as a sensor.
class StreamedReader final : public ScanReader {
 public:
  /// Reads on to the first scan.
  /// @param name  of the recording, for messages.
  /// @throws InputError where there is no scan, or what the source throws before the first one.
  StreamedReader(std::unique_ptr<ScanSource> source, const std::string& name,
                 const RecordingOptions& options = {});

  const ScanGeometry& geometry() const override { return given_.scan.geometry; }
  /// Waits for bytes that are still to come, whatever `timeout`. What interrupts that ends the recording.
  bool next(LaserScan& scan, Seconds timeout) override;
  const Truth* truth() const override;
  const Features* features() const override;
  const RecordingCounts& counts() const override { return counts_; }
  const RecordingMetadata& metadata() const override { return source_->metadata(); }

 private:
  bool read();

  std::unique_ptr<ScanSource> source_;
  double no_return_m_;
  RecordedScan given_;  // read last; the next one to give where is_ahead_
  RecordedScan spare_;  // storage that the source may leave in any state
  RecordingCounts counts_;
  bool is_ahead_ = false;
  bool is_over_ = false;
};

}  // namespace scanbed::hw
