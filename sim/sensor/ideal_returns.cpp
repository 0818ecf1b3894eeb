// SPDX-License-Identifier: MIT
#include "sim/sensor/ideal_returns.hpp"

#include <cstddef>

#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {

void IdealReturns::reset(int num_beams) {
  const auto n = static_cast<std::size_t>(num_beams);
  range_m.assign(n, kNoEcho);
  cos_incidence.assign(n, 1.0);
  object.assign(n, kNoObject);
  split_spots.clear();
  spot_returns.clear();
}

void IdealReturns::take_axes(const RayCaster& caster) {
  for (int i = 0; i < caster.num_beams(); ++i) {
    const int beam = caster.scan_beam(i);
    range_m[beam] = caster.range_m(i);
    object[beam] = caster.object(i);
    cos_incidence[beam] = caster.cos_incidence(i);
  }
}

}  // namespace scanbed::sim
