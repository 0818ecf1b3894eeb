// SPDX-License-Identifier: MIT
// Any bytes are replies of a Hokuyo sensor, or none: every scan has the beams of the sensor's parameters.
#include <cmath>

#include "core/errors/ensure.hpp"
#include "hw/scip/scip_laser.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using namespace scanbed;
using namespace scanbed::hw;

ScipParameters three_steps() {
  ScipParameters parameters = utm_30lx();
  parameters.last_step = 2;
  return parameters;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ScipReader reader;
  reader.feed({reinterpret_cast<const char*>(data), size});
  ScipScans scans(three_steps());
  LaserScan scan;
  for (std::vector<std::string> lines; reader.next(lines);) {
    SCANBED_ENSURE(!lines.empty());
    if (const auto parameters = parse_scip_parameters(lines)) {
      SCANBED_ENSURE(parameters->num_beams() >= 2);
      SCANBED_ENSURE(std::isfinite(parameters->geometry().bearing_rad(parameters->num_beams())));
      ScipScans of_these(*parameters);
    }
    if (scans.take(lines, 1.0, scan) != ScipScans::Outcome::kScan) continue;
    SCANBED_ENSURE(scan.num_beams() == 3 && std::isfinite(scan.time_s));
    for (const double range_m : scan.range_m)
      SCANBED_ENSURE(range_m == kNoEcho || (range_m >= 0.023 && range_m <= 60.0));
  }
  return 0;
}
