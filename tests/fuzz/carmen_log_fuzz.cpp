// SPDX-License-Identifier: MIT
// Any bytes are a log, or an InputError; every scan that a log gives is one that a detector may be given.
#include <cmath>
#include <string>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "hw/recording/carmen_log.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

void check(const scanbed::LaserScan& scan) {
  SCANBED_ENSURE(scan.geometry.num_beams == scan.num_beams());
  SCANBED_ENSURE(std::isfinite(scan.time_s));
  SCANBED_ENSURE(std::isfinite(scan.geometry.bearing_rad(scan.num_beams())));
  for (const double range_m : scan.range_m) {
    SCANBED_ENSURE(!std::isfinite(range_m) || (range_m > 0.0 && range_m < scan.geometry.max_range_m));
  }
  if (scan.X_OR) SCANBED_ENSURE(scan.X_OR->p_m.allFinite() && std::isfinite(scan.X_OR->theta_rad));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using scanbed::hw::CarmenLog;
  std::int64_t num_reports = 0;
  const auto report = [&](const std::string& message) {
    SCANBED_ENSURE(message.size() < 300 && message.find('\n') == std::string::npos);
    ++num_reports;
  };
  try {
    CarmenLog log(scanbed::hw::from_memory({reinterpret_cast<const char*>(data), size}), "input", {}, report);
    std::int64_t num_scans = 0;
    for (scanbed::LaserScan scan; log.next(scan, {});) {
      SCANBED_ENSURE(scan.index == num_scans++);
      check(scan);
    }
    SCANBED_ENSURE(log.counts().num_scans == num_scans);
    SCANBED_ENSURE(log.counts().num_damaged_lines == num_reports);
  } catch (const scanbed::InputError& error) {
    SCANBED_ENSURE(std::string(error.what()).starts_with("input: "));
  }
  return 0;
}
