// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "hw/recording/byte_stream.hpp"
#include "hw/recording/streamed_reader.hpp"

namespace scanbed::fuzz {

inline void check_scan(const LaserScan& scan) {
  SCANBED_ENSURE(scan.geometry.num_beams == scan.num_beams());
  SCANBED_ENSURE(std::isfinite(scan.time_s));
  SCANBED_ENSURE(std::isfinite(scan.geometry.bearing_rad(scan.num_beams())));
  for (const double range_m : scan.range_m) SCANBED_ENSURE(!std::isfinite(range_m) || range_m >= 0.0);
  if (scan.X_OR) SCANBED_ENSURE(scan.X_OR->p_m.allFinite() && std::isfinite(scan.X_OR->theta_rad));
}

inline void check_truth(const Truth& truth, const LaserScan& scan) {
  SCANBED_ENSURE(static_cast<int>(truth.beams.size()) == scan.num_beams());
  for (const BeamTruth& beam : truth.beams) {
    SCANBED_ENSURE(beam.object >= kNoObject && beam.object < static_cast<int>(truth.objects.size()));
  }
}

/// Any bytes are a recording, or an InputError; every scan that a recording gives is one that a detector may
/// be given. `open` makes a source of a stream, a name and a report.
template <class Open>
void read_any(const std::uint8_t* data, std::size_t size, const Open& open) {
  std::int64_t num_reports = 0;
  const auto report = [&](const std::string& message) {
    SCANBED_ENSURE(message.size() < 400 && message.find('\n') == std::string::npos);
    ++num_reports;
  };
  try {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    hw::StreamedReader reader(open(hw::from_memory(std::move(bytes)), "input", report), "input");
    std::int64_t num_scans = 0;
    for (LaserScan scan; reader.next(scan, {});) {
      SCANBED_ENSURE(scan.index == num_scans++);
      check_scan(scan);
      if (reader.truth() != nullptr) check_truth(*reader.truth(), scan);
    }
    SCANBED_ENSURE(reader.counts().num_scans == num_scans);
    SCANBED_ENSURE(reader.counts().num_damaged_lines == num_reports);
  } catch (const InputError& error) {
    SCANBED_ENSURE(std::string(error.what()).starts_with("input:"));
  }
}

}  // namespace scanbed::fuzz
