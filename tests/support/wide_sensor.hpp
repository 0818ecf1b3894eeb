// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/scan/range_sensor.hpp"

namespace scanbed::tests {

/// Endless scans of the whole turn, a beam every quarter degree from -180: beam i of scan n measures
/// 1000 + (i + n) mod 4000 millimetres.
class WideSensor final : public RangeSensor {
 public:
  WideSensor() {
    geometry_.num_beams = 1441;
    geometry_.first_rad = -kPi;
    geometry_.step_rad = radians(0.25);
  }

  static double range_m(std::int64_t scan, int beam) {
    return static_cast<double>(1000 + (beam + scan) % 4000) / 1000.0;
  }

  /// The beam of this sensor that points where `bearing_rad` does.
  static int beam_at(double bearing_rad) {
    return static_cast<int>(std::lround((bearing_rad + kPi) / radians(0.25)));
  }

  const ScanGeometry& geometry() const override { return geometry_; }

  bool next(LaserScan& scan, Seconds /*timeout*/) override {
    scan.geometry = geometry_;
    scan.index = next_++;
    scan.range_m.clear();
    for (int beam = 0; beam < geometry_.num_beams; ++beam) scan.range_m.push_back(range_m(scan.index, beam));
    return true;
  }

 private:
  ScanGeometry geometry_;
  std::int64_t next_ = 0;
};

}  // namespace scanbed::tests
