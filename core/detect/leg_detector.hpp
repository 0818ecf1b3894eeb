// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/segmentation.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Whether something nearer, or the edge of the field of view, may hide a part of the segment: the beam next
/// to either end met something nearer than that end, or there is no such beam.
bool is_partly_occluded(const LaserScan& scan, const Points& points, const Segment& segment);

/// Takes a segment for a leg if it bulges towards the sensor, is as wide as a leg, and is not partly
/// occluded.
///
/// @par Source  The paper, II-E, and IV-C for the least number of points.
std::optional<Leg> detect_leg(const LaserScan& scan, const Points& points, const Segment& segment,
                              const LegOptions& options);

/// Appends a leg to those that its score puts it among, if any.
void append_by_score(const Leg& leg, const LegOptions& options, Features& features);

}  // namespace scanbed
