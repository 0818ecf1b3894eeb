// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include "sim/planar/planar_slice.hpp"

namespace scanbed::test {

/// What one ray of the reference met.
struct ReferenceHit {
  double range_m = 0.0;  ///< kNoEcho where nothing was met
  int object = 0;        ///< kNoObject where nothing was met
};

/// The slow, independent ray caster: one b2World::RayCast for each beam. Box2D counts in single precision,
/// and does not see a disc from inside.
class B2ReferenceCaster {
 public:
  explicit B2ReferenceCaster(const sim::PlanarSlice& slice);
  ~B2ReferenceCaster();
  B2ReferenceCaster(const B2ReferenceCaster&) = delete;
  B2ReferenceCaster& operator=(const B2ReferenceCaster&) = delete;

  /// @param direction_W  of length 1.
  ReferenceHit cast(const Eigen::Vector2d& from_m, const Eigen::Vector2d& direction_W, double reach_m) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::test
