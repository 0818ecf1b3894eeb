// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "core/detect/features.hpp"
#include "core/simd/float_lanes.hpp"

namespace scanbed {

/// Where a candidate is: its beams, and its centroid in the sensor frame S.
struct LegPlace {
  BeamSpan beams;
  float x_m = 0.0F;
  float y_m = 0.0F;
};

/// Places of neighbouring candidates, one in each lane.
struct LegPlaceLanes {
  Ints first{}, last{};
  Floats x_m{}, y_m{};

  /// Reads the first places, as many as there are lanes for; lanes without keep what they had.
  void read(std::span<const LegPlace> places) {
    for (std::size_t i = 0; i < places.size() && i < kNumLanes; ++i) {
      first[i] = places[i].beams.first;
      last[i] = places[i].beams.last;
      x_m[i] = places[i].x_m;
      y_m[i] = places[i].y_m;
    }
  }
};

}  // namespace scanbed
