// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/scan/range_sensor.hpp"
#include "scenarios/run/truth_file.hpp"

namespace scanbed::scenarios {

struct LiveOptions {
  double patience_s = 90.0;           ///< without a scan, before it is an error; a sensor may start for 60 s
  double quiet_s = 5.0;               ///< without a scan, before the user is told what the device is at
  std::optional<std::int64_t> limit;  ///< scans after which the stream ends
  bool from_zero = false;             ///< times are counted from the first scan, as simulated ones are
  std::function<bool()> is_interrupted;        ///< asked ten times a second; true ends the stream
  std::optional<std::filesystem::path> truth;  ///< where truth of the scans is found
  /// Told in one line when what the device says of its own state changes, when scans stay away, and when 1,
  /// 10, 100, ... of them were dropped since they come faster than they are taken; may be empty.
  std::function<void(const std::string&)> warn;
};

/// "the laser reports a warning: its window is dirty", "the laser reports no trouble".
std::string describe(const SensorHealth& health);

/// A device as an end to a stream: waits for it in small steps, so that the user can break it off, ends after
/// as many scans as are wanted, and joins scans with truth that came another way.
class LiveSensor final : public RangeSensor {
 public:
  /// @throws InputError where the truth's file cannot be read.
  LiveSensor(std::unique_ptr<RangeSensor> device, const LiveOptions& options);

  const ScanGeometry& geometry() const override;

  /// Waits as options.patience_s says, whatever `timeout`.
  /// @throws SensorFault of the device; its kTimeout once patience is out. InputError where the truth's file
  ///         holds something else.
  bool next(LaserScan& scan, Seconds timeout) override;

  const Truth* truth() const override { return truth_; }

  std::int64_t num_truths() const { return num_truths_; }  ///< of scans so far

 private:
  bool wait_for_scan(LaserScan& scan);
  void watch(const SensorHealth& health);
  void watch_numbers(std::int64_t index);

  std::unique_ptr<RangeSensor> device_;
  LiveOptions options_;
  std::optional<TruthReader> reader_;
  const Truth* truth_ = nullptr;
  SensorHealth health_;
  std::optional<double> first_s_;
  std::int64_t num_scans_ = 0;
  std::int64_t num_dropped_to_tell_ = 1;
  std::int64_t num_truths_ = 0;
};

}  // namespace scanbed::scenarios
