// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/scene.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/track/track.hpp"

namespace scanbed::scenarios {

/// All that is known of one scan.
struct Findings {
  const LaserScan& scan;
  const Features& features;
  const std::vector<Track>* tracks = nullptr;  ///< where they were asked for
  const Scene* scene = nullptr;                ///< where it was asked for
};

}  // namespace scanbed::scenarios
