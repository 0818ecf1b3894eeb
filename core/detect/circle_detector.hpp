// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/segmentation.hpp"

namespace scanbed {

/// Standard deviation of inscribed angles up to which an arc is a circle; from here to kMaxArcLikeStd_rad it
/// is "arc-like", which a tree trunk may be (paper, II-B: 8.6 degrees, and II-B.3: 23 degrees). 8.6 degrees
/// are Table II's 0.15 rad; 0.402 is 23 degrees rounded up, so that radians(23) is allowed.
inline constexpr double kMaxCircleStd_rad = 0.15;
inline constexpr double kMaxArcLikeStd_rad = 0.402;

/// Takes a segment for a circle if its inscribed angles agree and average between 90 and 135 degrees.
///
/// @par Cost    O(1) for most segments (length and middle point), else O(n).
/// @par Source  The paper, II-B (detection, arc-like shapes), II-D (prerequisite), II-C (parameters). Departs
/// from what
///              II-C prints: the central angle is 360 deg - 2 IAV and the centre's height |P4| / 2
///              tan(theta), which is what eq. 1 gives; the centre lies behind the chord.
std::optional<Circle> detect_circle(const Points& points, const Segment& segment,
                                    const CircleOptions& options);

}  // namespace scanbed
