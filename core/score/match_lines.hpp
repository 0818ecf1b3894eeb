// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "core/score/match_options.hpp"
#include "core/score/tally.hpp"

namespace scanbed {

/// Compares the detected lines of one scan with the pieces of walls in view.
///
/// A line lies on a wall if angle and offset are within the gates. A piece is found if the lines on its wall
/// together cover enough of it; a line is right if enough of its length covers pieces of walls that it lies
/// on. So a wall may be found in several lines, and one line may find several collinear walls. Ends are not
/// compared: occlusion moves them. A line that has more than half of its beams on pieces of which too little
/// is seen (Visibility::kMarginal) is neither right nor wrong, however it lies.
KindScore match_lines(const std::vector<Line>& lines, const LaserScan& scan, const Truth& truth,
                      const MatchOptions& options);

}  // namespace scanbed
