// SPDX-License-Identifier: MIT
#include "tests/support/mj_reference_caster.hpp"

#include "core/scan/laser_scan.hpp"
#include "sim/spatial/spatial_slicer.hpp"

namespace scanbed::test {

double MjReferenceCaster::cast(const Eigen::Vector3d& from_m, const Eigen::Vector3d& direction_W) const {
  constexpr mjtByte kWithStatic = 1;
  constexpr int kExcludeNoBody = -1;
  int geom = -1;
  const double range_m = mj_ray(&model_, &data_, from_m.data(), direction_W.data(), sim::kLaserGroups.data(),
                                kWithStatic, kExcludeNoBody, &geom);
  return geom < 0 ? kNoEcho : range_m;
}

}  // namespace scanbed::test
