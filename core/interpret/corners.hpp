// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/interpret_options.hpp"
#include "core/interpret/scene.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Appends the corners: where neighbouring pieces of walls meet. An inner corner opens towards the sensor, an
/// outer one points at it.
///
/// @param lines  of the scan; they rise in beams.first.
void find_corners(const std::vector<Line>& lines, const LaserScan& scan, const InterpretOptions& options,
                  Scene& scene);

}  // namespace scanbed
