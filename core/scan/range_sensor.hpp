// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"

namespace scanbed {

/// The one interface between a source of scans and everything downstream: simulated, recorded, networked or
/// real.
class RangeSensor {
 public:
  using Seconds = std::chrono::duration<double>;
  static constexpr Seconds kPatience{2.0};  ///< longer than any laser needs for a scan

  RangeSensor() = default;
  RangeSensor(const RangeSensor&) = delete;
  RangeSensor& operator=(const RangeSensor&) = delete;
  virtual ~RangeSensor() = default;

  /// Geometry of the scans to come, as far as it is known before they arrive.
  virtual const ScanGeometry& geometry() const = 0;

  /// Waits for the next scan and writes it over `scan`, reusing its storage.
  ///
  /// @returns false at the end of the stream; `scan` is then untouched, and so it stays on further calls.
  /// @throws SensorFault of kind kTimeout if nothing arrives within `timeout` (sources that never wait ignore
  /// it),
  ///         of another kind if the source fails.
  virtual bool next(LaserScan& scan, Seconds timeout) = 0;

  /// Truth of the scan that next() gave last; nullptr where the source has none. Valid until the next call of
  /// next().
  virtual const Truth* truth() const { return nullptr; }
};

}  // namespace scanbed
