// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_source.hpp"

namespace scanbed::hw {

/// The scans of a ScanSource as a sensor.
class StreamedReader final : public ScanReader {
 public:
  /// Reads on to the first scan. @param name, only  of the recording and of the source that alone is read, if
  ///                                one is; for messages.
  /// @throws InputError where there is no scan, or what the source throws before the first one.
  StreamedReader(std::unique_ptr<ScanSource> source, const std::string& name, const std::string& only = {});

  const ScanGeometry& geometry() const override { return given_.scan.geometry; }
  bool next(LaserScan& scan, Seconds timeout) override;
  const Truth* truth() const override;
  const Features* features() const override;
  const RecordingCounts& counts() const override { return counts_; }
  const RecordingMetadata& metadata() const override { return source_->metadata(); }

 private:
  bool read();

  std::unique_ptr<ScanSource> source_;
  RecordedScan given_;  // read last; the next one to give where is_ahead_
  RecordedScan spare_;  // storage that the source may leave in any state
  RecordingCounts counts_;
  bool is_ahead_ = false;
  bool is_over_ = false;
};

}  // namespace scanbed::hw
