// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "core/detect/features.hpp"
#include "core/scan/range_sensor.hpp"

namespace scanbed::hw {

/// What a recording held, counted as it is read.
struct RecordingCounts {
  std::int64_t num_scans = 0;
  std::int64_t num_damaged_lines = 0;  ///< lines or records that should have been a scan, and were skipped
  std::int64_t num_other_lines = 0;    ///< comments, parameters and other lines or records without a scan
};

/// What is known about a recording as a whole: "scenario", "seed", "configuration", ... Both sides are text.
using RecordingMetadata = std::map<std::string, std::string>;

/// Called for each damaged line or record, which is then skipped: one line with the file and the place.
using DamageReport = std::function<void(const std::string&)>;

/// A recording as a sensor: its scans in the order of the file, or of time where its format promises no
/// order (see time_order.hpp), numbered from 0. The first one is read ahead,
/// so that geometry() is known. It waits for nothing but bytes that are still to arrive (see PacedReplay),
/// and its memory does not grow with the file.
class ScanReader : public RangeSensor {
 public:
  /// Of what was read so far: one scan more than next() gave until its first call.
  virtual const RecordingCounts& counts() const = 0;

  /// What the recording says of itself; empty for formats that say nothing.
  virtual const RecordingMetadata& metadata() const = 0;

  /// Features recorded with the scan that next() gave last; nullptr where there are none. Valid until the
  /// next call of next().
  virtual const Features* features() const { return nullptr; }
};

}  // namespace scanbed::hw
