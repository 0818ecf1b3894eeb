// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/scan/range_sensor.hpp"
#include "hw/sick/lms_configuration.hpp"
#include "hw/sick/lms_variant.hpp"

namespace scanbed::hw {

/// Makes the sensor whose scans an emulated LMS hands on, for what its host configured. A variant of 180
/// degrees at 0.25 is asked for where the host wants turns of the mirror one by one.
using ScanSupply = std::function<std::unique_ptr<RangeSensor>(const LmsStreamSettings&)>;

/// A scan on its way to the wire.
struct SentScan {
  std::int64_t number = 0;  ///< counts the scans sent from 0
  const LaserScan& scan;    ///< as the source gave it
  std::span<const std::uint16_t> words;
  RangeUnit unit;
  LmsWordFormat format;
  const Truth* truth;  ///< nullptr where the source has none
};

/// Turns the scans of any sensor into the words of an LMS. Where the source ends it begins anew.
class ScanFeed {
 public:
  using Observer = std::function<void(const SentScan&)>;

  /// @param observer  is told of each scan before it is sent; may be empty.
  ScanFeed(ScanSupply source, Observer observer);

  /// Makes a new sensor of the source.
  /// @throws what the source throws.
  void restart(const LmsStreamSettings& settings, const LmsWordFormat& format);

  /// Whether restart() has been called.
  bool is_started() const { return sensor_ != nullptr; }

  /// Words of the next scan, counter-clockwise. Beams that the source does not have are without echo.
  /// @throws what the source throws; SensorFault kProtocol where it holds no scan at all.
  const std::vector<std::uint16_t>& next();

  std::int64_t num_scans() const { return num_scans_; }

 private:
  void take_scan();

  ScanSupply source_;
  Observer observer_;
  LmsStreamSettings settings_;
  LmsWordFormat format_;
  std::unique_ptr<RangeSensor> sensor_;
  LaserScan scan_;
  std::vector<std::uint16_t> words_;
  std::int64_t num_scans_ = 0;
};

}  // namespace scanbed::hw
