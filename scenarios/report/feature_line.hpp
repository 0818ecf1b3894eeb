// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed::scenarios {

/// Appends one scan's features as a JSON object and a newline: what `detect` prints. Metres, seconds and
/// radians, sensor frame; features rise in their first beam; numbers are rounded to 1e-6, slope and bias of a
/// line along y are null. The keys are a public interface: further ones may be added, none renamed.
void append_feature_line(std::string& out, const LaserScan& scan, const Features& features);

}  // namespace scanbed::scenarios
