// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/interpret_options.hpp"
#include "core/interpret/scene.hpp"
#include "core/scan/scan_geometry.hpp"

namespace scanbed {

/// Appends the corners: where neighbouring pieces of walls meet. An inner corner opens towards the sensor, an
/// outer one points at it.
///
/// @param lines  rise in beams.first.
void find_corners(const std::vector<Line>& lines, const ScanGeometry& geometry,
                  const InterpretOptions& options, Scene& scene);

}  // namespace scanbed
