// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "hw/recording/left_out_sources.hpp"
#include "hw/recording/scan_reader.hpp"

namespace scanbed::hw {

/// A scan as a recording holds it.
struct RecordedScan {
  LaserScan scan;
  std::optional<Features> features;
  std::optional<Truth> truth;
};

/// What differs between formats: how the next scan is found and decoded. StreamedReader makes a sensor of it.
class ScanSource {
 public:
  ScanSource() = default;
  ScanSource(const ScanSource&) = delete;
  ScanSource& operator=(const ScanSource&) = delete;
  virtual ~ScanSource() = default;

  /// Reads the next scan, all fields but its index; false at the end. Counts damaged and other records.
  /// @throws InputError where the recording cannot be read on (cut off, damaged).
  /// @throws SensorFault where the operating system fails to read.
  virtual bool read(RecordedScan& out) = 0;

  static constexpr double kNoDeadline_s = std::numeric_limits<double>::infinity();

  /// How a wait for the next scan came out.
  enum class Arrival { kScan, kEnd, kNothingYet };

  /// read() that waits no longer than to `deadline_s` of steady_now_s() for a scan that is still to arrive.
  /// Sources that do not say otherwise wait as long as it takes, as without a deadline.
  virtual Arrival read_until(RecordedScan& out, double /*deadline_s*/) {
    return read(out) ? Arrival::kScan : Arrival::kEnd;
  }

  const RecordingCounts& counts() const { return counts_; }
  const RecordingMetadata& metadata() const { return metadata_; }
  const LeftOutSources& left_out() const { return left_out_; }

 protected:
  RecordingCounts counts_;
  RecordingMetadata metadata_;
  LeftOutSources left_out_;  // what has scans that were not asked for
};

}  // namespace scanbed::hw
