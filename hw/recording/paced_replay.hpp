// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <limits>
#include <memory>
#include <optional>

#include "hw/recording/scan_reader.hpp"

namespace scanbed::hw {

/// Which part of a recording is given, and how fast.
struct ReplayOptions {
  std::optional<double> speed;  ///< 1: as it was recorded; 2: twice as fast; empty: as fast as it can be read
  double from_s = 0.0;          ///< scans before this time, since the first scan, are left out
  double to_s = std::numeric_limits<double>::infinity();  ///< scans after this time are left out

  void validate() const;  ///< @throws InputError naming the first field that is not allowed
};

/// A recording that is given in the rhythm of its times, or only a part of it. Scans are numbered from 0
/// again.
class PacedReplay final : public ScanReader {
 public:
  /// @throws InputError where the options do not validate or the part holds no scan.
  PacedReplay(std::unique_ptr<ScanReader> reader, const ReplayOptions& options);

  const ScanGeometry& geometry() const override { return first_.geometry; }

  /// With a speed: waits until it is the scan's time; the timeout is ignored. A gap of more than a minute is
  /// cut short, and a signal to the program ends the wait, so that it never hangs.
  bool next(LaserScan& scan, Seconds timeout) override;
  const Truth* truth() const override { return is_ahead_ ? nullptr : reader_->truth(); }
  const Features* features() const override { return is_ahead_ ? nullptr : reader_->features(); }
  /// Scans are those that were given; damaged and other lines are all that were read.
  const RecordingCounts& counts() const override { return counts_; }
  const RecordingMetadata& metadata() const override { return reader_->metadata(); }

 private:
  using Clock = std::chrono::steady_clock;

  bool take(LaserScan& scan);
  bool read(LaserScan& scan);
  void wait_for(double time_s);

  std::unique_ptr<ScanReader> reader_;
  ReplayOptions options_;
  LaserScan first_;  // of the part; the next one to give where is_ahead_
  LaserScan spare_;
  bool is_ahead_ = false;
  bool is_over_ = false;
  std::optional<double> start_s_;  // time of the recording's first scan
  RecordingCounts counts_;
  double given_s_ = 0.0;      // time of the scan that was given last
  Clock::time_point due_at_;  // when it was due
};

}  // namespace scanbed::hw
