// SPDX-License-Identifier: MIT
// Any bytes are frames of an LMS1xx or TiM, or none; every scan is one that a detector may be given.
#include <cmath>

#include "core/errors/ensure.hpp"
#include "hw/cola/cola_frame.hpp"
#include "hw/cola/cola_scan.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using namespace scanbed;
using namespace scanbed::hw;

void check(const std::string& body) {
  const auto telegram = parse_cola_scan(body);
  LaserScan scan;
  if (!telegram || !to_laser_scan(*telegram, scan)) return;
  SCANBED_ENSURE(scan.num_beams() == scan.geometry.num_beams);
  SCANBED_ENSURE(std::isfinite(scan.geometry.bearing_rad(scan.num_beams())) && scan.geometry.step_rad > 0.0);
  for (const double range_m : scan.range_m)
    SCANBED_ENSURE(range_m == kNoEcho || (range_m > 0.0 && std::isfinite(range_m)));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ColaReader reader;
  reader.feed({data, size});
  for (std::string body; reader.next(body);) check(body);
  check(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
