// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/scene.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "core/score/match_options.hpp"
#include "core/track/track.hpp"
#include "scenarios/load/expect.hpp"

namespace scanbed::scenarios {

/// One scan with what was detected in it.
struct DetectedScan {
  const LaserScan& scan;
  const Features& features;
  const Truth* truth = nullptr;                ///< null where the laser has none
  const std::vector<Track>* tracks = nullptr;  ///< null where nothing is followed
  const Scene* scene = nullptr;                ///< null where nothing is interpreted
};

/// Whether the condition holds in this scan; empty where the scan cannot tell: no truth, no scene,
/// nothing to find (recall), or nothing detected (precision).
std::optional<bool> holds(const ScanCondition& condition, const DetectedScan& detected,
                          const MatchOptions& match);

}  // namespace scanbed::scenarios
