// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/scan/range_sensor.hpp"
#include "hw/sick/scan_feed.hpp"
#include "tests/support/numbered_steps.hpp"

namespace scanbed::tests {

/// The number of a whole scan; empty where any of its beams is not that scan's.
inline std::optional<std::int64_t> number_of(const LaserScan& scan, double steps_per_m = 1000.0) {
  const auto steps = [&](int beam) {
    return std::lround(scan.range_m[static_cast<std::size_t>(beam)] * steps_per_m);
  };
  if (scan.num_beams() < 2) return std::nullopt;
  const std::int64_t number = steps(0) + 8000 * steps(1);
  for (int beam = 0; beam < scan.num_beams(); ++beam) {
    if (steps(beam) != numbered_steps(number, beam)) return std::nullopt;
  }
  return number;
}

/// Endless scans of numbered_steps(). Numbers go on from one sensor to the next by way of `next_number`.
class NumberedSensor final : public RangeSensor {
 public:
  NumberedSensor(const hw::LmsStreamSettings& settings, std::shared_ptr<std::int64_t> next_number)
      : settings_(settings), next_number_(std::move(next_number)) {
    geometry_.num_beams = settings.variant.num_beams();
    geometry_.first_rad = -0.5 * radians(settings.variant.fov_deg);
    geometry_.step_rad = radians(settings.variant.resolution_cdeg / 100.0);
  }

  const ScanGeometry& geometry() const override { return geometry_; }

  bool next(LaserScan& scan, Seconds /*timeout*/) override {
    scan.geometry = geometry_;
    scan.index = (*next_number_)++;
    scan.range_m.resize(static_cast<std::size_t>(geometry_.num_beams));
    for (int beam = 0; beam < geometry_.num_beams; ++beam) {
      scan.range_m[static_cast<std::size_t>(beam)] =
          numbered_steps(scan.index, beam) * lms_step_m(settings_.unit);
    }
    return true;
  }

 private:
  hw::LmsStreamSettings settings_;
  std::shared_ptr<std::int64_t> next_number_;
  ScanGeometry geometry_;
};

inline hw::ScanSupply numbered_source() {
  const auto next_number = std::make_shared<std::int64_t>(0);
  return [next_number](const hw::LmsStreamSettings& settings) {
    return std::make_unique<NumberedSensor>(settings, next_number);
  };
}

}  // namespace scanbed::tests
