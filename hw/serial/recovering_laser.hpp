// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/scan/range_sensor.hpp"
#include "hw/serial/device_refusal.hpp"
#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {

struct RecoveryOptions {
  double pause_s = 1.0;        ///< between two attempts
  int num_first_attempts = 3;  ///< before the first scan; afterwards there is no end of them
  int max_waiting = 64;        ///< scans kept for a reader that is busy; then the oldest are dropped
};

/// Attempts, in a thread of its own, to stream from a device, again and again.
class RecoveringLaser final : public RangeSensor {
 public:
  /// Hands on a scan whose time is of steady_now_s(); its index is set here.
  using Give = std::function<void(LaserScan&)>;
  /// Opens the device and streams until something fails, which it throws: DeviceRefusal ends all attempts,
  /// SensorFault leads to another one. Leaves with Stopped when the signal is given.
  using Attempt = std::function<void(const Give&, const StopSignal&)>;

  /// @param name  of the device, for messages.
  RecoveringLaser(std::string name, const RecoveryOptions& options, Attempt attempt);
  ~RecoveringLaser() override;

  /// Of the scan that next() gave last; of an LMS 200 before that, since the device has not told its own yet.
  const ScanGeometry& geometry() const override;

  /// Times are seconds since a second before construction, so that none is negative.
  /// @throws SensorFault kTimeout where no scan comes in time; of another kind where the device refuses, or
  ///         the first attempts failed.
  bool next(LaserScan& scan, Seconds timeout) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::hw
